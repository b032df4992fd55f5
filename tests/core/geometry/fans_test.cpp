#include "core/geometry/fans.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>

#include "core/geometry/fan_votes.h"
#include "core/io/point_io.h"
#include "tests/support/delaunay_referee.h"
#include "tests/support/shapes.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

// Counts of fans; `differentUnshifted` are those that differ from stars without the tie-breaking shifts.
struct Comparison {
  int compared = 0, different = 0, differentUnshifted = 0;

  Comparison& operator+=(const Comparison& other) {
    compared += other.compared;
    different += other.different;
    differentUnshifted += other.differentUnshifted;
    return *this;
  }
};

// Compares the closed and certified fans with the Delaunay stars of `k` neighbors in the same plane.
Comparison compareWithReferee(const Sites& sites, const FanSet& set, int k) {
  constexpr std::size_t kBlock = 256;
  const NeighborSearch search(sites.positions, k);
  const auto shifts = tieBreakShifts(sites.positions);
  std::vector<Comparison> blocks((sites.size() + kBlock - 1) / kBlock);
  parallelFor(sites.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    Comparison& block = blocks[begin / kBlock];
    std::vector<Index> neighbors;
    std::vector<float> squared;
    std::vector<PlanePoint> points;
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      if (set.fans.open[i] || !set.fans.certified[i]) continue;
      const auto spokes = set.fans.of(i);
      const std::vector<Index> fan(spokes.begin(), spokes.end());
      search.findNearest(i, k, neighbors, squared);
      const auto differs = [&](std::span<const Eigen::Vector3f> moved) {
        mapToTangentPlane(sites.positions, moved, i, set.normals[i], neighbors, Metric::kUnfolded, points);
        return !sameCycle(fan, delaunayStar(points));
      };
      block += {.compared = 1, .different = differs(shifts), .differentUnshifted = differs({})};
    }
  });
  return std::accumulate(blocks.begin(), blocks.end(), Comparison{},
                         [](Comparison sum, const Comparison& block) { return sum += block; });
}

void expectStars(const std::vector<Eigen::Vector3f>& positions) {
  const Sites sites = weldAndOrder(positions);
  const FanSet set = buildFans(sites, {});
  const Comparison result = compareWithReferee(sites, set, 64);
  EXPECT_GT(result.compared, static_cast<int>(0.97 * sites.size()));
  EXPECT_EQ(result.different, 0) << "of " << result.compared;
  // Ties within the shifts of 1e-6 of a spacing.
  EXPECT_LE(result.differentUnshifted, result.compared / 2000 + 1);
  std::printf("%u sites, %d certified (%.2f %%) and compared: %d differ, %d where ties are not broken\n",
              sites.size(), result.compared, 100.0 * result.compared / sites.size(), result.different,
              result.differentUnshifted);
}

void expectStarsOf(const char* file) {
  STIPPLE_NEEDS_TEST_DATA();
  Progress progress;
  const PointSet points = readPoints(testData(file), progress).points;
  expectStars({points.positions().begin(), points.positions().end()});
}

TEST(Fans, EqualDelaunayStarsOnARandomSphere) {
  expectStars(shapes::randomSphere(20000));
}
TEST(Fans, EqualDelaunayStarsOnTheBunny) {
  expectStarsOf("smooth/bun_zipper_binary_le_points.ply");
}
TEST(Fans, EqualDelaunayStarsOnIgea) {
  expectStarsOf("smooth/igea_134k.ply");
}
TEST(Fans, EqualDelaunayStarsOnTheArmadillo) {
  expectStarsOf("smooth/armadillo_43k.obj");
}
TEST(Fans, EqualDelaunayStarsOnTheRockerArm) {
  expectStarsOf("cad/rocker-arm.obj");
}

TEST(Fans, NoCertifiedFanChangesWhenAllPointsAreLookedAt) {
  for (const int k : {8, 16, 24}) {
    const Sites sites = weldAndOrder(shapes::randomSphere(1200, 5));
    const FanSet set = buildFans(sites, {.k = k, .maxK = k});
    const Comparison result = compareWithReferee(sites, set, 1199);
    EXPECT_GT(result.compared, k < 16 ? 20 : 600);
    EXPECT_EQ(result.different, 0) << "k " << k << ", of " << result.compared;
  }
}

TEST(Fans, GridsChooseOneDiagonal) {
  const Eigen::Matrix3f turned =
      Eigen::AngleAxisf(0.7f, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
  for (const Eigen::Matrix3f& rotation : {Eigen::Matrix3f(Eigen::Matrix3f::Identity()), turned}) {
    const FanSet set = buildFans(weldAndOrder(shapes::grid(100, rotation)), {});
    EXPECT_EQ(std::count(set.fans.open.begin(), set.fans.open.end(), 1), 4 * 99);
    EXPECT_GT(shareOfConsistentTriangles(set.fans), 0.9999);
    // Interior edges of a triangulated square, each seen from both ends (Euler's formula); along the rim a
    // flat triangle may be seen from one end only.
    EXPECT_NEAR(static_cast<double>(set.fans.neighbors.size()), 2 * (3 * 99 * 99 + 2 * 99), 4);
  }
}

TEST(Fans, OpenAlongTheRimOfAnAnnulusAndClosedInside) {
  // 20 000 points between the radii .5 and 1.
  auto square = shapes::randomSquare(60000, 9);
  std::vector<Eigen::Vector3f> ring;
  for (const auto& p : square) {
    const Eigen::Vector3f q = 2 * (p - Eigen::Vector3f(0.5f, 0.5f, 0));
    if (q.norm() > 0.5f && q.norm() < 1 && ring.size() < 20000) ring.push_back(q);
  }
  const Sites sites = weldAndOrder(ring);
  const double area = 3.14159265 * 0.75, spacing = std::sqrt(area / sites.size());
  const FanSet set = buildFans(sites, {});
  int openInside = 0, closedAtRim = 0, atRim = 0;
  for (Index i = 0; i < sites.size(); ++i) {
    const double radius = sites.positions[i].norm(), distance = std::min(radius - 0.5, 1 - radius);
    if (distance > 4 * spacing) openInside += set.fans.open[i];
    if (distance < 0.25 * spacing) {
      ++atRim;
      closedAtRim += !set.fans.open[i];
    }
    for (const Index j : set.fans.of(i)) {
      EXPECT_LT((sites.positions[i] - sites.positions[j]).norm(), 8 * spacing);
    }
  }
  EXPECT_EQ(openInside, 0);
  EXPECT_LT(closedAtRim, atRim / 5);
}

TEST(Fans, DoNotDependOnTheNumberOfThreads) {
  const Sites sites = weldAndOrder(shapes::randomSphere(20000, 3));
  const ThreadLimit one(1);
  const FanSet single = buildFans(sites, {});
  const ThreadLimit all(0);
  EXPECT_EQ(single.fans.neighbors, buildFans(sites, {}).fans.neighbors);
}

TEST(Fans, CancelledWhenAsked) {
  struct Stop : Progress {
    bool cancelled() const override { return true; }
  } stop;
  EXPECT_THROW(buildFans(weldAndOrder(shapes::randomSphere(10000)), {}, &stop), Cancelled);
}

}  // namespace
}  // namespace stipple
