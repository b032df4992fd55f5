#include "app/tools/measure.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

TEST(Measure, TellsTheStraightWayFromTheOneAlongTheSurface) {
  const SurfaceDistance sphere(PointSet(shapes::randomSphere(20000)));
  const glm::vec3 from(0, 0, 1), to(0.6f, 0, -0.8f);
  const double arc = std::numbers::pi - std::asin(0.6);
  const Measurement measured = measure(sphere, from, to);
  EXPECT_NEAR(measured.straight, std::sqrt(0.36 + 1.8 * 1.8), 1e-6);
  ASSERT_TRUE(measured.alongSurface);
  EXPECT_GT(*measured.alongSurface, 0.995 * arc);
  EXPECT_LT(*measured.alongSurface, 1.08 * arc);
  EXPECT_EQ(measured.path.front(), from);
  EXPECT_EQ(measured.path.back(), to);
  for (const glm::vec3& place : measured.path) EXPECT_NEAR(glm::length(place), 1, 1e-3f);
}

TEST(Measure, TheSamePlaceIsNoWayAway) {
  const SurfaceDistance sphere(PointSet(shapes::randomSphere(1000)));
  const Measurement measured = measure(sphere, {0, 0, 1}, {0, 0, 1});
  EXPECT_EQ(measured.straight, 0);
  EXPECT_EQ(measured.alongSurface, 0);
}

TEST(Measure, SaysWhereNoPathLeads) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(500);
  for (const Eigen::Vector3f& p : shapes::randomSphere(500, 2))
    positions.push_back(p + Eigen::Vector3f(9, 0, 0));
  const SurfaceDistance spheres{PointSet(positions)};
  const Measurement measured = measure(spheres, {0, 0, 1}, {9, 0, 1});
  EXPECT_NEAR(measured.straight, 9, 1e-6);
  EXPECT_FALSE(measured.alongSurface);
  EXPECT_TRUE(measured.path.empty());
}

}  // namespace
}  // namespace stipple
