#include "core/geometry/consensus.h"

#include <algorithm>
#include <iterator>

#include "core/geometry/consensus_patch.h"
#include "core/geometry/fan_votes.h"

namespace stipple {

namespace {

// The fans with the changed ones in place of their own.
Fans splice(const Fans& fans, std::vector<PatchFan>& changed) {
  std::sort(changed.begin(), changed.end(),
            [](const PatchFan& a, const PatchFan& b) { return a.site < b.site; });
  Fans result;
  result.open = fans.open;
  result.certified = fans.certified;
  result.offsets.reserve(fans.offsets.size());
  result.neighbors.reserve(fans.neighbors.size());
  result.flags.reserve(fans.flags.size());
  std::size_t next = 0;
  for (Index site = 0; site < fans.size(); ++site) {
    if (next < changed.size() && changed[next].site == site) {
      const PatchFan& fan = changed[next++];
      result.neighbors.insert(result.neighbors.end(), fan.spokes.begin(), fan.spokes.end());
      result.flags.insert(result.flags.end(), fan.spokes.size(), 0);
      if (fan.open) result.flags.back() = Fans::kGapAfter;
      result.open[site] = fan.open;
    } else {
      const auto spokes = fans.of(site);
      const auto flags = fans.flagsOf(site);
      result.neighbors.insert(result.neighbors.end(), spokes.begin(), spokes.end());
      result.flags.insert(result.flags.end(), flags.begin(), flags.end());
    }
    result.offsets.push_back(static_cast<Index>(result.neighbors.size()));
  }
  return result;
}

}  // namespace

std::vector<std::uint8_t> reachConsensus(std::span<const Eigen::Vector3f> positions,
                                         std::span<const Eigen::Vector3f> normals, Fans& fans,
                                         const Progress* progress) {
  const DisputedPatches disputed = findDisputed(fans, progress);
  std::vector<std::vector<PatchFan>> results(disputed.size());
  parallelFor(
      results.size(), 16,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
          results[p] = resolvePatch(positions, normals, fans, disputed.of(p)).fans;
      },
      progress);

  std::vector<std::uint8_t> resolved(fans.size(), 1);
  for (Index site = 0; site < fans.size(); ++site) resolved[site] = !fans.of(site).empty();
  for (const VotedTriangle& t : disputed.triangles) {
    for (const Index corner : t.corners) resolved[corner] = 0;
  }
  std::vector<PatchFan> changed;
  for (auto& patch : results) std::move(patch.begin(), patch.end(), std::back_inserter(changed));
  for (const PatchFan& fan : changed) resolved[fan.site] = 1;
  fans = splice(fans, changed);
  return resolved;
}

}  // namespace stipple
