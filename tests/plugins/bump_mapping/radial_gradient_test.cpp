#include "plugins/bump_mapping/radial_gradient.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

// On a regular grid the gradient of a linear function is a fixed share of the true one, in its direction; the
// share is what differences of Eq. (15) give.
TEST(RadialGradient, IsThatOfTheInterpolation) {
  Progress progress;
  const PointSet points(shapes::grid(41));
  const Discretization d = discretize(points, {}, progress);
  std::vector<double> values;
  for (const Eigen::Vector3f& p : d.sites.positions) values.push_back(std::sin(5 * p.x()) + 2 * p.y());
  const double radius = 0.06;
  const std::vector<Eigen::Vector3d> gradients = radialGradient(d, values, radius);
  const auto interpolate = [&](const Eigen::Vector3d& x) {
    double sum = 0, weights = 0;
    for (Index q = 0; q < d.size(); ++q) {
      const double r = (d.sites.positions[q].cast<double>() - x).norm() / radius;
      const double w = r < 1 ? 2 * r * r * r - 3 * r * r + 1 : 0;
      sum += w * values[q];
      weights += w;
    }
    return sum / weights;
  };
  for (Index site = 7; site < d.size(); site += 100) {
    const Eigen::Vector3d x = d.sites.positions[site].cast<double>();
    constexpr double kStep = 1e-5;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      const double difference = (interpolate(x + step) - interpolate(x - step)) / (2 * kStep);
      EXPECT_NEAR(gradients[site][axis], difference, 1e-3);
    }
    EXPECT_EQ(gradients[site].z(), 0);
  }
}

TEST(RadialGradient, IsZeroWhereNothingIsNear) {
  Progress progress;
  const Discretization d = discretize(PointSet(shapes::grid(5)), {}, progress);
  const std::vector<double> values(25, 4.0);
  for (const Eigen::Vector3d& gradient : radialGradient(d, values, 0.01)) EXPECT_EQ(gradient.norm(), 0);
}

}  // namespace
}  // namespace stipple
