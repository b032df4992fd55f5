#include "core/geometry/consensus.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "core/geometry/consensus_patch.h"
#include "core/geometry/site_sets.h"

namespace stipple {

bool hasTriangle(const Fans& fans, Index site, Index a, Index b) {
  const auto spokes = fans.of(site);
  const auto flags = fans.flagsOf(site);
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    if (spokes[s] != a) continue;
    const std::size_t next = s + 1 == spokes.size() ? 0 : s + 1,
                      previous = s == 0 ? spokes.size() - 1 : s - 1;
    return (spokes[next] == b && !(flags[s] & Fans::kGapAfter)) ||
           (spokes[previous] == b && !(flags[previous] & Fans::kGapAfter));
  }
  return false;
}

namespace {

// Calls visit(triangle corners in fan order, multiplicity) for the triangles of one fan.
template <class Visit>
void forEachTriangle(const Fans& fans, Index site, Visit&& visit) {
  const auto spokes = fans.of(site);
  const auto flags = fans.flagsOf(site);
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    if (flags[s] & Fans::kGapAfter) continue;
    const Index a = spokes[s], b = spokes[s + 1 == spokes.size() ? 0 : s + 1];
    visit(Triangle{site, a, b}, 1 + hasTriangle(fans, a, site, b) + hasTriangle(fans, b, site, a));
  }
}

std::vector<VotedTriangle> findDisputed(const Fans& fans, const Progress* progress) {
  constexpr std::size_t kBlock = 8192;
  std::vector<std::vector<VotedTriangle>> parts((fans.size() + kBlock - 1) / kBlock);
  parallelFor(
      fans.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (auto site = static_cast<Index>(begin); site < end; ++site) {
          forEachTriangle(fans, site, [&](Triangle corners, int votes) {
            if (votes == 3) return;
            std::sort(corners.begin(), corners.end());
            parts[begin / kBlock].push_back({corners, votes});
          });
        }
      },
      progress);
  std::vector<VotedTriangle> disputed;
  for (const auto& part : parts) disputed.insert(disputed.end(), part.begin(), part.end());
  std::sort(disputed.begin(), disputed.end(),
            [](const VotedTriangle& a, const VotedTriangle& b) { return a.corners < b.corners; });
  const auto twice =
      std::unique(disputed.begin(), disputed.end(),
                  [](const VotedTriangle& a, const VotedTriangle& b) { return a.corners == b.corners; });
  disputed.erase(twice, disputed.end());
  return disputed;
}

// Disputed triangles of one patch are made adjacent; returns where each patch begins.
std::vector<std::size_t> groupByPatch(std::vector<VotedTriangle>& disputed, Index sites) {
  SiteSets sets(sites);
  for (const VotedTriangle& t : disputed) {
    sets.join(t.corners[0], t.corners[1]);
    sets.join(t.corners[0], t.corners[2]);
  }
  std::stable_sort(disputed.begin(), disputed.end(), [&](const VotedTriangle& a, const VotedTriangle& b) {
    return sets.rootOf(a.corners[0]) < sets.rootOf(b.corners[0]);
  });
  std::vector<std::size_t> begins;
  for (std::size_t t = 0; t < disputed.size(); ++t) {
    if (t == 0 || sets.rootOf(disputed[t].corners[0]) != sets.rootOf(disputed[t - 1].corners[0]))
      begins.push_back(t);
  }
  begins.push_back(disputed.size());
  return begins;
}

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
  std::vector<VotedTriangle> disputed = findDisputed(fans, progress);
  const std::vector<std::size_t> begins = groupByPatch(disputed, fans.size());

  std::vector<std::vector<PatchFan>> results(begins.size() - 1);
  parallelFor(
      results.size(), 16,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
          const std::span patch(disputed.data() + begins[p], begins[p + 1] - begins[p]);
          results[p] = resolvePatch(positions, normals, fans, patch);
        }
      },
      progress);

  std::vector<std::uint8_t> resolved(fans.size(), 1);
  for (Index site = 0; site < fans.size(); ++site) resolved[site] = !fans.of(site).empty();
  for (const VotedTriangle& t : disputed) {
    for (const Index corner : t.corners) resolved[corner] = 0;
  }
  std::vector<PatchFan> changed;
  for (auto& patch : results) std::move(patch.begin(), patch.end(), std::back_inserter(changed));
  for (const PatchFan& fan : changed) resolved[fan.site] = 1;
  fans = splice(fans, changed);
  return resolved;
}

double shareOfConsistentTriangles(const Fans& fans) {
  std::atomic<std::size_t> all{0}, agreed{0};
  parallelFor(fans.size(), 8192, [&](std::size_t begin, std::size_t end) {
    std::size_t blockAll = 0, blockAgreed = 0;
    for (auto site = static_cast<Index>(begin); site < end; ++site) {
      forEachTriangle(fans, site, [&](const Triangle&, int votes) {
        ++blockAll;
        blockAgreed += votes == 3;
      });
    }
    all += blockAll;
    agreed += blockAgreed;
  });
  return all == 0 ? 1.0 : static_cast<double>(agreed) / static_cast<double>(all);
}

}  // namespace stipple
