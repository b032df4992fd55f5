#include "core/geometry/consensus.h"

#include "core/geometry/fan_votes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

struct Complex {
  std::set<Triangle> triangles;
  std::map<std::pair<Index, Index>, int> edges;
  int boundary = 0, nonManifold = 0, disputed = 0;
};

Complex collect(const Fans& fans) {
  Complex complex;
  for (Index i = 0; i < fans.size(); ++i) {
    const auto spokes = fans.of(i);
    for (std::size_t s = 0; s < spokes.size(); ++s) {
      if (fans.flagsOf(i)[s] & Fans::kGapAfter) continue;
      Triangle t{i, spokes[s], spokes[(s + 1) % spokes.size()]};
      complex.disputed += !hasTriangle(fans, t[1], t[0], t[2]) || !hasTriangle(fans, t[2], t[0], t[1]);
      std::sort(t.begin(), t.end());
      complex.triangles.insert(t);
    }
  }
  for (const Triangle& t : complex.triangles) {
    for (const auto& e : {std::pair{t[0], t[1]}, std::pair{t[0], t[2]}, std::pair{t[1], t[2]}})
      ++complex.edges[e];
  }
  for (const auto& [edge, count] : complex.edges) {
    complex.boundary += count == 1;
    complex.nonManifold += count > 2;
  }
  return complex;
}

TEST(Consensus, RandomSpheresBecomeClosedSurfacesOfEulerNumberTwo) {
  for (const int n : {500, 2000, 8000, 32000}) {
    const Sites sites =
        weldAndOrder(shapes::randomSphere(static_cast<std::size_t>(n), static_cast<std::uint64_t>(n)));
    FanSet set = buildFans(sites, {});
    const auto resolved = reachConsensus(sites.positions, set.normals, set.fans);
    EXPECT_EQ(std::count(resolved.begin(), resolved.end(), 1), n);
    const Complex complex = collect(set.fans);
    EXPECT_EQ(complex.disputed, 0);
    EXPECT_EQ(complex.boundary, 0);
    EXPECT_EQ(complex.nonManifold, 0);
    EXPECT_EQ(n - static_cast<int>(complex.edges.size()) + static_cast<int>(complex.triangles.size()), 2);
  }
}

TEST(Consensus, KeepsAnEdgeTwoTrianglesOnNoisyData) {
  auto points = shapes::randomSphere(5000, 6);
  std::mt19937_64 random(6);
  std::normal_distribution<float> noise(0, 0.03f);
  for (auto& p : points) p *= 1 + noise(random);
  const Sites sites = weldAndOrder(points);
  FanSet set = buildFans(sites, {});
  const Fans before = set.fans;
  const auto resolved = reachConsensus(sites.positions, set.normals, set.fans);
  const double share = shareOfConsistentTriangles(set.fans);
  EXPECT_GT(share, shareOfConsistentTriangles(before));
  // Triangles between resolved sites stand in all three fans.
  for (Index i = 0; i < sites.size(); ++i) {
    const auto spokes = set.fans.of(i);
    for (std::size_t s = 0; resolved[i] && s < spokes.size(); ++s) {
      const Index a = spokes[s], b = spokes[(s + 1) % spokes.size()];
      if ((set.fans.flagsOf(i)[s] & Fans::kGapAfter) || !resolved[a] || !resolved[b]) continue;
      EXPECT_TRUE(hasTriangle(set.fans, a, i, b) && hasTriangle(set.fans, b, i, a))
          << i << " " << a << " " << b;
    }
  }
  // Where a site was not resolved, its own fan stands.
  for (Index i = 0; i < sites.size(); ++i) {
    if (resolved[i]) continue;
    EXPECT_TRUE(std::ranges::equal(set.fans.of(i), before.of(i))) << i;
  }
}

TEST(Consensus, DependsNeitherOnRowOrderNorOnThreads) {
  auto points = shapes::randomSphere(20000, 8);
  const Sites sites = weldAndOrder(points);
  FanSet set = buildFans(sites, {});
  reachConsensus(sites.positions, set.normals, set.fans);
  std::reverse(points.begin(), points.end());
  const ThreadLimit one(1);
  const Sites again = weldAndOrder(points);
  FanSet other = buildFans(again, {});
  reachConsensus(again.positions, other.normals, other.fans);
  EXPECT_EQ(set.fans.neighbors, other.fans.neighbors);
}

}  // namespace
}  // namespace stipple
