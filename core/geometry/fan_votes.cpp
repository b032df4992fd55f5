#include "core/geometry/fan_votes.h"

#include <algorithm>
#include <atomic>

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

constexpr std::size_t kBlock = 8192;

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

template <class T>
void append(std::vector<std::vector<T>>& parts, std::vector<T>& all) {
  std::size_t sum = 0;
  for (const auto& part : parts) sum += part.size();
  all.reserve(sum);
  for (auto& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    part = {};
  }
}

// Disputed triangles of one patch are made adjacent.
void groupByPatch(DisputedPatches& disputed, Index sites) {
  SiteSets sets(sites);
  for (const VotedTriangle& t : disputed.triangles) {
    sets.join(t.corners[0], t.corners[1]);
    sets.join(t.corners[0], t.corners[2]);
  }
  const auto patchOf = [&](const VotedTriangle& t) { return sets.rootOf(t.corners[0]); };
  std::ranges::stable_sort(disputed.triangles, {}, patchOf);
  disputed.begins.clear();
  for (std::size_t t = 0; t < disputed.triangles.size(); ++t) {
    if (t == 0 || patchOf(disputed.triangles[t]) != patchOf(disputed.triangles[t - 1]))
      disputed.begins.push_back(t);
  }
  disputed.begins.push_back(disputed.triangles.size());
}

}  // namespace

DisputedPatches findDisputed(const Fans& fans, const Progress* progress, std::vector<Triangle>* settled) {
  std::vector<std::vector<Triangle>> settledParts((fans.size() + kBlock - 1) / kBlock);
  std::vector<std::vector<VotedTriangle>> disputedParts(settledParts.size());
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (auto site = static_cast<Index>(begin); site < end; ++site) {
      forEachTriangle(fans, site, [&](Triangle t, int votes) {
        if (votes == 3) {
          if (settled && t[0] < t[1] && t[0] < t[2]) settledParts[begin / kBlock].push_back(t);
          return;
        }
        std::ranges::sort(t);
        disputedParts[begin / kBlock].push_back({t, votes});
      });
    }
  };
  parallelFor(fans.size(), kBlock, look, progress);
  if (settled) append(settledParts, *settled);
  DisputedPatches disputed;
  append(disputedParts, disputed.triangles);
  std::ranges::sort(disputed.triangles, {}, &VotedTriangle::corners);
  const auto twice = std::ranges::unique(disputed.triangles, {}, &VotedTriangle::corners);
  disputed.triangles.erase(twice.begin(), twice.end());
  groupByPatch(disputed, fans.size());
  return disputed;
}

double shareOfConsistentTriangles(const Fans& fans) {
  std::atomic<std::size_t> all{0}, agreed{0};
  parallelFor(fans.size(), kBlock, [&](std::size_t begin, std::size_t end) {
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
