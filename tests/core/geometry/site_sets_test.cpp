#include "core/geometry/site_sets.h"

#include <gtest/gtest.h>

#include <random>

namespace stipple {
namespace {

using Pair = std::pair<Index, Index>;

// The smallest site that can be reached from each, by passing it on along the pairs until nothing changes.
std::vector<Index> smallestReached(Index sites, const std::vector<Pair>& pairs) {
  std::vector<Index> least(sites);
  std::iota(least.begin(), least.end(), Index{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : pairs) {
      const Index both = std::min(least[a], least[b]);
      changed = changed || least[a] != both || least[b] != both;
      least[a] = least[b] = both;
    }
  }
  return least;
}

TEST(SiteSets, RootsAreTheSmallestMembersInWhateverOrderPairsAreJoined) {
  std::mt19937 random(3);
  for (const std::size_t count : {0u, 40u, 100u, 150u, 600u}) {
    constexpr Index kSites = 200;
    std::vector<Pair> pairs;
    for (std::size_t n = 0; n < count; ++n) pairs.emplace_back(random() % kSites, random() % kSites);
    const std::vector<Index> expected = smallestReached(kSites, pairs);
    for (int order = 0; order < 3; ++order) {
      SiteSets sets(kSites);
      for (const auto& [a, b] : pairs) sets.join(a, b);
      for (Index site = 0; site < kSites; ++site) EXPECT_EQ(sets.rootOf(site), expected[site]);
      std::shuffle(pairs.begin(), pairs.end(), random);
    }
  }
}

}  // namespace
}  // namespace stipple
