#include "core/geometry/local_fan.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <random>

#include "tests/support/delaunay_referee.h"

namespace stipple {
namespace {

std::vector<PlanePoint> sorted(std::vector<PlanePoint> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].squaredNorm = points[i].x * points[i].x + points[i].y * points[i].y;
    points[i].site = static_cast<Index>(i);
  }
  std::sort(points.begin(), points.end(),
            [](const PlanePoint& a, const PlanePoint& b) { return a.squaredNorm < b.squaredNorm; });
  return points;
}

std::vector<Index> sitesOf(const LocalFan& fan, const std::vector<PlanePoint>& points) {
  std::vector<Index> sites;
  for (const auto& spoke : fan.spokes()) sites.push_back(points[spoke.point].site);
  return sites;
}

TEST(LocalFan, EqualsTheDelaunayStarOnRandomPoints) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 2000; ++round) {
    std::vector<PlanePoint> points(40);
    for (PlanePoint& p : points) p = {normal(random), normal(random)};
    points = sorted(points);
    LocalFan fan;
    fan.clip(points, 100);
    if (fan.open()) continue;
    EXPECT_TRUE(sameCycle(sitesOf(fan, points), delaunayStar(points))) << "round " << round;
  }
}

TEST(LocalFan, ExactPredicatesDecideNearTies) {
  // Twelve points on a circle through the origin's neighbors, each moved by some 1e-15: any of them may be in
  // the star, and only exact signs give the star that the referee gives.
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> jitter(-4e-16, 4e-16);
  for (int round = 0; round < 500; ++round) {
    std::vector<PlanePoint> points;
    for (int i = 0; i < 12; ++i) {
      const double angle = 0.5235987755982988 * i;
      points.push_back({0.3 + std::cos(angle) + jitter(random), 0.1 + std::sin(angle) + jitter(random)});
    }
    points = sorted(points);
    LocalFan fan;
    fan.clip(points, 100);
    ASSERT_FALSE(fan.open());
    EXPECT_TRUE(sameCycle(sitesOf(fan, points), delaunayStar(points))) << "round " << round;
  }
}

TEST(LocalFan, OpensTowardsAHalfPlaneWithoutPoints) {
  const auto points = sorted({{1, 0}, {0.5, 0.9}, {-0.5, 0.9}, {-1, 0}});
  LocalFan fan;
  fan.clip(points, 1.5);
  EXPECT_TRUE(fan.open());
  EXPECT_EQ(sitesOf(fan, points), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_FALSE(fan.spokes()[0].gapAfter);
  EXPECT_TRUE(fan.spokes()[3].gapAfter);
}

TEST(LocalFan, ACornerBeyondTheSquareIsAGapNotATriangle) {
  // The circumcircle of the origin and the two points has a radius of 10.
  const auto points = sorted({{1, 0.05}, {-1, 0.05}, {0, -1}});
  LocalFan fan;
  fan.clip(points, 2);
  ASSERT_EQ(fan.spokes().size(), 3u);
  EXPECT_TRUE(fan.open());
  int gaps = 0;
  for (const auto& spoke : fan.spokes()) gaps += spoke.gapAfter;
  EXPECT_EQ(gaps, 1);
}

TEST(LocalFan, MinimumAngleDropsTheThinTriangle) {
  auto points = sorted({{1, 0}, {0.995, 0.1}, {0, 1}, {-1, 0}, {0, -1}, {0.7, 0.72}});
  LocalFan fan;
  fan.clip(points, 100);
  EXPECT_EQ(fan.spokes().size(), 6u);
  fan.clipWithMinAngle(points, 100, 10 * 3.14159265 / 180);
  EXPECT_EQ(fan.spokes().size(), 5u);  // one of the two at an angle of 6 degrees is gone
  EXPECT_FALSE(fan.open());
}

TEST(LocalFan, NoPointsNoSpokes) {
  LocalFan fan;
  fan.clip({}, 1);
  EXPECT_TRUE(fan.open());
  EXPECT_TRUE(fan.spokes().empty());
}

TEST(TangentBasis, IsOrthonormalAndRightHanded) {
  for (const Eigen::Vector3f& n : {Eigen::Vector3f(0, 0, 1), Eigen::Vector3f(0, 0, -1),
                                   Eigen::Vector3f(1, 0, 0), Eigen::Vector3f(0.6f, -0.64f, 0.48f)}) {
    const TangentBasis basis = tangentBasisOf(n);
    EXPECT_NEAR(basis.e0.norm(), 1, 1e-14);
    EXPECT_NEAR(basis.e0.dot(basis.normal), 0, 1e-14);
    EXPECT_NEAR((basis.e0.cross(basis.e1) - n.cast<double>()).norm(), 0, 1e-6);
  }
}

}  // namespace
}  // namespace stipple
