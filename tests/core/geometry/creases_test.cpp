#include "core/geometry/creases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/creased_shapes.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Two half planes from the y axis, the second turned down by `turn`; centers at a and b from the axis.
double turnOf(double turn, double a, double b) {
  const OneSidedPlane left = {Eigen::Vector3f(static_cast<float>(-a), 0.2f, 0), Eigen::Vector3f::UnitZ()};
  const Eigen::Vector3d right(b * std::cos(turn), -0.3, -b * std::sin(turn));
  const Eigen::Vector3d normal(std::sin(turn), 0, std::cos(turn));
  // The sign of a normal means nothing.
  return turningAngle(left, {right.cast<float>(), -normal.cast<float>()});
}

TEST(Creases, TurningIsThatOfTheFoldUpToBlades) {
  for (const double degrees : {5.0, 30.0, 60.0, 89.0, 100.0, 120.0, 140.0, 150.0}) {
    EXPECT_NEAR(turnOf(degrees * kDegree, 1, 1), degrees * kDegree, 1e-3) << degrees;
    EXPECT_NEAR(turnOf(degrees * kDegree, 1, 1.7), degrees * kDegree, 1e-3) << degrees;
  }
  const OneSidedPlane plane = {Eigen::Vector3f(1, 2, 3), Eigen::Vector3f::UnitX()};
  EXPECT_EQ(turningAngle(plane, plane), 0);
}

TEST(Creases, BesideACreasePlanesAreThoseOfOneSide) {
  const double turn = 70 * kDegree;
  const shapes::FacedPoints fold = shapes::foldedSquare(turn, 6000, 9);
  const Sites sites = weldAndOrder(fold.positions);
  const std::vector<OneSidedPlane> planes = fitOneSidedPlanes(sites, {});
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7 + 9, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix();
  const Eigen::Vector3d normals[2] = {rotation * Eigen::Vector3d::UnitZ(),
                                      rotation * Eigen::Vector3d(std::sin(turn), 0, std::cos(turn))};
  int mixed = 0;
  for (Index i = 0; i < sites.size(); ++i) {
    const Eigen::Vector3d n = planes[i].normal.cast<double>();
    if (std::max(std::abs(n.dot(normals[0])), std::abs(n.dot(normals[1]))) < std::cos(2 * kDegree)) ++mixed;
  }
  EXPECT_LT(mixed, 12) << "of 6000";
}

TEST(Creases, FewPointsAndCopiesAreHarmless) {
  EXPECT_EQ(fitOneSidedPlanes(weldAndOrder(std::vector<Eigen::Vector3f>{}), {}).size(), 0u);
  const std::vector<Eigen::Vector3f> two = {{0, 0, 0}, {1, 0, 0}};
  for (const OneSidedPlane& plane : fitOneSidedPlanes(weldAndOrder(two), {})) {
    EXPECT_NEAR(plane.normal.norm(), 1, 1e-5);
  }
}

TEST(Creases, NeighborsGrowWithTheNoise) {
  EXPECT_EQ(creaseNeighbors(0), 48);
  EXPECT_GT(creaseNeighbors(0.1), 48);
  EXPECT_EQ(creaseNeighbors(5), 200);
}

}  // namespace
}  // namespace stipple
