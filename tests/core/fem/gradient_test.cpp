#include "core/fem/gradient.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

Discretization discretizeQuietly(const PointSet& points, const DiscretizationOptions& options = {}) {
  Progress progress;
  return discretize(points, options, progress);
}

template <class Function>
std::vector<double> valuesOf(const Discretization& d, Function&& function) {
  std::vector<double> values;
  for (const Eigen::Vector3f& p : d.sites.positions) values.push_back(function(p.cast<double>()));
  return values;
}

// Relative L2 error of the gradient of z on the unit sphere, whose truth is e_z minus its part along p.
double errorOfZ(std::size_t count, const DiscretizationOptions& options) {
  const Discretization d = discretizeQuietly(PointSet(shapes::randomSphere(count)), options);
  const auto gradients = fanGradient(d, valuesOf(d, [](const Eigen::Vector3d& p) { return p.z(); }));
  double error = 0, whole = 0;
  for (Index i = 0; i < d.size(); ++i) {
    const Eigen::Vector3d p = d.sites.positions[i].cast<double>();
    const Eigen::Vector3d truth = Eigen::Vector3d::UnitZ() - p.z() * p;
    error += (gradients[i] - truth).squaredNorm();
    whole += truth.squaredNorm();
  }
  return std::sqrt(error / whole);
}

TEST(FanGradient, OfLinearFunctionsOnAPlaneIsExact) {
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.7f, Eigen::Vector3f(1, 2, -1).normalized()).toRotationMatrix();
  std::vector<Eigen::Vector3f> tilted = shapes::randomSquare(3000);
  for (Eigen::Vector3f& p : tilted) p = turn * p;
  const Eigen::Vector3d slope(0.3, -2, 1.1), normal = turn.col(2).cast<double>();
  const Eigen::Vector3d truth = slope - normal * normal.dot(slope);
  for (const Scheme scheme : {Scheme::kVoronoi, Scheme::kElement, Scheme::kPaper}) {
    const Discretization d = discretizeQuietly(PointSet(tilted), {.scheme = scheme});
    const auto values = valuesOf(d, [&](const Eigen::Vector3d& p) { return slope.dot(p) + 5; });
    for (const Eigen::Vector3d& g : fanGradient(d, values)) EXPECT_LT((g - truth).norm(), 2e-3);
  }
}

TEST(FanGradient, OfLinearFunctionsOnTrianglesIsExact) {
  PointSet points(shapes::grid(3));
  points.setTriangles({{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}});
  const Discretization d = discretizeQuietly(points, {.scheme = Scheme::kMesh});
  const auto values = valuesOf(d, [](const Eigen::Vector3d& p) { return 2 * p.x() - 3 * p.y(); });
  for (const Eigen::Vector3d& g : fanGradient(d, values)) {
    EXPECT_LT((g - Eigen::Vector3d(2, -3, 0)).norm(), 1e-12);
  }
}

// The design's table: .0246 for angle weights against .029 for equal ones and .050 for areas.
TEST(FanGradient, OnARandomSphereIsWithinTwoAndAHalfPercent) {
  for (const bool consensus : {true, false}) EXPECT_LT(errorOfZ(20000, {.consensus = consensus}), 0.0255);
}

TEST(FanGradient, Converges) {
  // Linear elements on irregular points: order 1 in the spacing, so half the error from four times the
  // points.
  const double coarse = errorOfZ(5000, {}), fine = errorOfZ(80000, {});
  EXPECT_LT(fine, 0.3 * coarse);
}

TEST(FanGradient, IsTangentialAndZeroForConstants) {
  const Discretization d = discretizeQuietly(PointSet(shapes::randomSphere(2000)));
  for (const auto& g : fanGradient(d, std::vector<double>(d.size(), 3.5))) EXPECT_EQ(g.norm(), 0);
  const auto gradients = fanGradient(d, valuesOf(d, [](const Eigen::Vector3d& p) { return p.x() * p.y(); }));
  for (Index i = 0; i < d.size(); ++i) {
    EXPECT_NEAR(gradients[i].dot(d.normals[i].cast<double>()), 0, 1e-6);
  }
}

TEST(FanGradient, WithoutTrianglesIsZero) {
  const Discretization lonely = discretizeQuietly(PointSet(std::vector<Eigen::Vector3f>{{1, 2, 3}}));
  EXPECT_EQ(fanGradient(lonely, std::vector<double>{7.0})[0].norm(), 0);
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 50; ++i) line.emplace_back(static_cast<float>(i), 0.f, 0.f);
  const Discretization d = discretizeQuietly(PointSet(line));
  const auto values = valuesOf(d, [](const Eigen::Vector3d& p) { return p.x(); });
  for (const auto& g : fanGradient(d, values)) EXPECT_EQ(g.norm(), 0);
}

}  // namespace
}  // namespace stipple
