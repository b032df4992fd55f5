#include "core/fem/gradient.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

// Relative L2 error of the tangential gradient of a function of z on the unit sphere.
template <class Function, class Derivative>
double errorOnSphere(const Discretization& d, Function&& function, Derivative&& derivative) {
  const auto values = valuesOf(d, [&](const Eigen::Vector3d& p) { return function(p.z()); });
  const auto gradients = fanGradient(d, values);
  double error = 0, whole = 0;
  for (Index i = 0; i < d.size(); ++i) {
    const Eigen::Vector3d p = d.sites.positions[i].cast<double>();
    const Eigen::Vector3d truth = derivative(p.z()) * (Eigen::Vector3d::UnitZ() - p.z() * p);
    error += (gradients[i] - truth).squaredNorm();
    whole += truth.squaredNorm();
  }
  return std::sqrt(error / whole);
}

double errorOfZ(const Discretization& d) {
  return errorOnSphere(
      d, [](double z) { return z; }, [](double) { return 1.0; });
}

// The zonal harmonic of degree 4.
double errorOfY40(const Discretization& d) {
  return errorOnSphere(
      d, [](double z) { return (35 * z * z * z * z - 30 * z * z + 3) / 8; },
      [](double z) { return (140 * z * z * z - 60 * z) / 8; });
}

// The largest error for a linear function on random points of a plane, in any scheme.
double errorOnPlane(const Eigen::Matrix3f& turn) {
  std::vector<Eigen::Vector3f> points = shapes::randomSquare(3000);
  for (Eigen::Vector3f& p : points) p = turn * p;
  const Eigen::Vector3d slope(0.3, -2, 1.1), normal = turn.col(2).cast<double>();
  const Eigen::Vector3d truth = slope - normal * normal.dot(slope);
  double error = 0;
  for (const Scheme scheme : {Scheme::kVoronoi, Scheme::kElement, Scheme::kPaper}) {
    const Discretization d = discretizeQuietly(PointSet(points), {.scheme = scheme});
    const auto values = valuesOf(d, [&](const Eigen::Vector3d& p) { return slope.dot(p) + 5; });
    for (const Eigen::Vector3d& g : fanGradient(d, values)) error = std::max(error, (g - truth).norm());
  }
  return error;
}

TEST(FanGradient, OfLinearFunctionsOnAPlaneIsExact) {
  EXPECT_LT(errorOnPlane(Eigen::Matrix3f::Identity()), 1e-6);
  // Turned points are off their plane by the rounding of floats, which flat triangles enlarge.
  const Eigen::Vector3f axis = Eigen::Vector3f(1, 2, -1).normalized();
  EXPECT_LT(errorOnPlane(Eigen::AngleAxisf(0.7f, axis).toRotationMatrix()), 1e-3);
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

// The table of the design has .0246 for angle weights, .029 for equal ones, .050 for areas.
TEST(FanGradient, OnARandomSphereIsWithinTwoAndAHalfPercent) {
  for (const bool consensus : {true, false}) {
    const Discretization d =
        discretizeQuietly(PointSet(shapes::randomSphere(20000)), {.consensus = consensus});
    EXPECT_LT(errorOfZ(d), 0.0246);
    EXPECT_LT(errorOfY40(d), 0.0246);
  }
}

// Linear elements on irregular points: order 1 in the spacing, so a quarter of the error from 16 times the
// points.
TEST(FanGradient, ConvergesWithTheSpacing) {
  const Discretization coarse = discretizeQuietly(PointSet(shapes::randomSphere(5000))),
                       fine = discretizeQuietly(PointSet(shapes::randomSphere(80000)));
  EXPECT_LT(errorOfZ(fine), 0.27 * errorOfZ(coarse));
  EXPECT_LT(errorOfY40(fine), 0.27 * errorOfY40(coarse));
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
