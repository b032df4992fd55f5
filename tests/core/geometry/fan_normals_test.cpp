#include "core/geometry/fan_normals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/geometry/discretization.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

struct Square {
  Discretization d;
  Eigen::MatrixXd places;
  std::vector<Eigen::Vector3f> up;

  Square() {
    Progress progress;
    d = discretize(PointSet(shapes::randomSquare(2000, 5)), {}, progress);
    places.resize(d.size(), 3);
    for (Index i = 0; i < d.size(); ++i) places.row(i) = d.sites.positions[i].cast<double>().transpose();
    up.assign(d.size(), Eigen::Vector3f::UnitZ());
  }
};

TEST(FanNormals, OfAPlaneThatTurns) {
  const Square square;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).matrix();
  const Eigen::Vector3f normal = turn.col(2).cast<float>();
  std::vector<Eigen::Vector3f> along = square.up;
  for (std::size_t i = 0; i < along.size(); i += 2) along[i] = -along[i];
  const std::vector<Eigen::Vector3f> normals =
      fanNormals(square.d.fans, square.places * turn.transpose(), along);
  for (std::size_t i = 0; i < along.size(); ++i)
    EXPECT_LT((normals[i] - (i % 2 == 0 ? -1.f : 1.f) * normal).norm(), 1e-6f) << i;
}

// A paraboloid z = a x^2 + b y^2 has the gradient (2 a x, 2 b y); a fan is off by the third order only.
TEST(FanNormals, FollowTheSurface) {
  Square square;
  const auto height = [](double x, double y) { return 0.3 * x * x - 0.2 * y * y; };
  for (Eigen::Index i = 0; i < square.places.rows(); ++i)
    square.places(i, 2) = height(square.places(i, 0), square.places(i, 1));
  const std::vector<Eigen::Vector3f> normals = fanNormals(square.d.fans, square.places, square.up);
  for (Index i = 0; i < square.d.size(); ++i) {
    const double x = square.places(i, 0), y = square.places(i, 1);
    const Eigen::Vector3d wanted = Eigen::Vector3d(-0.6 * x, 0.4 * y, 1).normalized();
    // Half a fan, at the border, is off by the curvature times a spacing.
    const double bound = square.d.fans.open[i] ? 0.06 : 0.02;
    EXPECT_LT((normals[i].cast<double>() - wanted).norm(), bound) << i;
  }
}

TEST(FanNormals, WithoutAreaStay) {
  Square square;
  square.places.setConstant(3);
  EXPECT_EQ(fanNormals(square.d.fans, square.places, square.up), square.up);
}

}  // namespace
}  // namespace stipple
