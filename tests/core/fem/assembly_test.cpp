#include "core/fem/assembly.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <numeric>

#include "core/geometry/fan_weights.h"
#include "core/io/point_io.h"
#include "tests/support/harmonic_errors.h"
#include "tests/support/hull_referee.h"
#include "tests/support/shapes.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

Discretization discretized(const PointSet& points, const DiscretizationOptions& options = {}) {
  Progress progress;
  return discretize(points, options, progress);
}

Eigen::Map<const Eigen::VectorXd> vectorOf(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

// What every matrix must be, whatever the cloud.
void expectSound(const Discretization& d, const SparseMatrix& stiffness) {
  const Eigen::VectorXd rowSums = stiffness * Eigen::VectorXd::Ones(stiffness.cols());
  const double scale = std::max(1.0, stiffness.diagonal().cwiseAbs().maxCoeff());
  EXPECT_LT(rowSums.cwiseAbs().maxCoeff(), 1e-12 * scale);
  EXPECT_EQ((SparseMatrix(stiffness.transpose()) - stiffness).norm(), 0);
  EXPECT_GT(stiffness.diagonal().minCoeff(), 0) << "an isolated point";
  // M + tau L with a large tau is positive definite: no pivot is negative.
  double area = 0;
  for (const double m : d.mass) area += m;
  Eigen::SparseMatrix<double> system = stiffness * (1e3 * area / d.size());
  system.diagonal() += vectorOf(d.mass);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(system);
  ASSERT_EQ(factor.info(), Eigen::Success);
  EXPECT_GT(factor.vectorD().minCoeff(), 0);
}

int positiveOffDiagonals(const SparseMatrix& matrix) {
  int count = 0;
  for (int row = 0; row < matrix.outerSize(); ++row) {
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
      count += entry.col() != row && entry.value() > 0;
  }
  return count;
}

class OnRealScans : public testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(OnRealScans, MatricesAreSound) {
  STIPPLE_NEEDS_TEST_DATA();
  Progress progress;
  const PointSet points = readPoints(testData(std::get<0>(GetParam())), progress).points;
  const bool consensus = std::get<1>(GetParam());
  const Discretization voronoi = discretized(points, {.consensus = consensus});
  const SparseMatrix stiffness = assembleStiffness(voronoi);
  expectSound(voronoi, stiffness);
  EXPECT_EQ(positiveOffDiagonals(stiffness), 0);

  const Discretization element = discretized(points, {.scheme = Scheme::kElement, .consensus = consensus});
  expectSound(element, assembleStiffness(element));
  // A strongly anisotropic tensor, turned from site to site.
  std::vector<Eigen::Matrix3d> tensor(element.size());
  for (Index i = 0; i < element.size(); ++i) {
    const Eigen::Vector3d direction =
        element.sites.positions[i].cast<double>().cross(Eigen::Vector3d(1, 2, 3));
    const Eigen::Vector3d along = direction.norm() > 0 ? direction.normalized() : Eigen::Vector3d::UnitX();
    tensor[i] = 0.01 * Eigen::Matrix3d::Identity() + 0.99 * along * along.transpose();
  }
  expectSound(element, assembleStiffness(element, tensor));
}

INSTANTIATE_TEST_SUITE_P(
    Assembly, OnRealScans,
    testing::Combine(testing::Values("cad/casting.off", "cad/cube_noisy.off",
                                     "noisy/sphere_20k_noise_outliers.xyz", "noisy/lidar_street_source.ply",
                                     "noisy/lato000_rangemap.ply", "noisy/lato180_rangemap.ply"),
                     testing::Bool()));

TEST(Assembly, LinearFunctionsOfAPlaneAreHarmonicInside) {
  for (const Scheme scheme : {Scheme::kVoronoi, Scheme::kElement, Scheme::kPaper}) {
    const Discretization d = discretized(PointSet(shapes::randomSquare(3000)), {.scheme = scheme});
    const SparseMatrix stiffness = assembleStiffness(d);
    Eigen::VectorXd linear(d.size());
    for (Index i = 0; i < d.size(); ++i)
      linear[i] = 2 * d.sites.positions[i].x() - 3 * d.sites.positions[i].y();
    const Eigen::VectorXd residual = stiffness * linear;
    for (Index i = 0; i < d.size(); ++i) {
      bool inside = !d.fans.open[i];
      for (const Index j : d.fans.of(i)) inside = inside && !d.fans.open[j];
      if (inside) {
        EXPECT_NEAR(residual[i], 0, 2e-5) << i;
      }
    }
  }
}

// The pole of a sphere that a program wrote as sin(pi) cos(phi), sin(pi) sin(phi), -1: not one place, though
// nothing beside it is told apart as finely.
TEST(Assembly, PointsAlmostAtOnePlaceKeepTheMatrixDefinite) {
  std::vector<Eigen::Vector3f> positions;
  for (const Eigen::Vector3f& p : shapes::grid(21)) positions.push_back(p - Eigen::Vector3f(0.5f, 0.5f, 0));
  for (int i = 0; i < 40; ++i) {
    const float angle = 0.157f * static_cast<float>(i);
    positions.emplace_back(1.2e-16f * std::cos(angle), 1.2e-16f * std::sin(angle), 0.f);
  }
  for (const Scheme scheme : {Scheme::kVoronoi, Scheme::kElement}) {
    const Discretization d = discretized(PointSet(positions), {.scheme = scheme});
    const SparseMatrix stiffness = assembleStiffness(d);
    expectSound(d, stiffness);
    for (int row = 0; row < stiffness.outerSize(); ++row) {
      for (SparseMatrix::InnerIterator entry(stiffness, row); entry; ++entry)
        EXPECT_TRUE(entry.col() == row || std::abs(entry.value()) <= 2 * kMostWeight) << entry.value();
    }
  }
}

TEST(Assembly, TheEnergyOfALinearFunctionIsItsSlopeSquaredTimesTheArea) {
  const Discretization d = discretized(PointSet(shapes::grid(80)), {.scheme = Scheme::kElement});
  const Eigen::Matrix3d a = Eigen::Vector3d(1, 0.1, 1).asDiagonal();
  const SparseMatrix stiffness = assembleStiffness(d, std::vector<Eigen::Matrix3d>(d.size(), a));
  Eigen::VectorXd linear(d.size());
  for (Index i = 0; i < d.size(); ++i)
    linear[i] = 2 * d.sites.positions[i].x() - 3 * d.sites.positions[i].y();
  EXPECT_NEAR(linear.dot(stiffness * linear), 4 * 1 + 9 * 0.1, 1e-3);
}

TEST(Assembly, EdgeMeans) {
  const Discretization d = discretized(PointSet(shapes::grid(20)));
  std::vector<double> diffusivity(d.size(), 1);
  for (Index i = 0; i < d.size(); ++i) diffusivity[i] = d.sites.positions[i].x() > 0.5f ? 0 : 1;
  const SparseMatrix blocked = assembleStiffness(d, diffusivity, EdgeMean::kHarmonic);
  const SparseMatrix mean = assembleStiffness(d, diffusivity, EdgeMean::kArithmetic);
  const SparseMatrix plain = assembleStiffness(d);
  for (int i = 0; i < plain.outerSize(); ++i) {
    for (SparseMatrix::InnerIterator entry(plain, i); entry; ++entry) {
      if (entry.col() == i) continue;
      const double a = diffusivity[static_cast<Index>(i)], b = diffusivity[static_cast<Index>(entry.col())];
      EXPECT_NEAR(blocked.coeff(i, entry.col()), entry.value() * (a > 0 && b > 0 ? 1 : 0), 1e-12);
      EXPECT_NEAR(mean.coeff(i, entry.col()), entry.value() * 0.5 * (a + b), 2e-5);
    }
  }
}

TEST(Assembly, SchemeMeshIsTheCotangentMatrix) {
  // One equilateral triangle: cotangents of 60 degrees.
  PointSet points({{0, 0, 0}, {1, 0, 0}, {0.5f, 0.8660254f, 0}});
  points.setTriangles({{0, 1, 2}});
  const SparseMatrix stiffness = assembleStiffness(discretized(points, {.scheme = Scheme::kMesh}));
  const double half = 0.5 / std::tan(3.14159265358979 / 3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(stiffness.coeff(i, j), i == j ? 2 * half : -half, 1e-7);
  }
}

class OnRandomSpheres : public testing::TestWithParam<int> {};

TEST_P(OnRandomSpheres, AsAccurateAsTheHullsCotangents) {
  const int n = GetParam();
  for (const std::uint64_t seed : {1u, 7u}) {
    const auto positions = shapes::randomSphere(static_cast<std::size_t>(n), seed);
    PointSet points(positions);
    points.setTriangles(hullTriangles(positions));
    const auto hull = harmonicErrors(discretized(points, {.scheme = Scheme::kMesh}));
    const auto voted = harmonicErrors(discretized(points));
    const auto local = harmonicErrors(discretized(points, {.consensus = false}));
    for (std::size_t h = 0; h < 3; ++h) {
      EXPECT_LT(voted[h], 1.1 * hull[h]) << "harmonic " << h << " seed " << seed;
    }
    // Without consensus no worse either.
    for (std::size_t h = 0; h < 3; ++h) {
      EXPECT_LT(local[h], 1.1 * hull[h]) << "harmonic " << h << " seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Assembly, OnRandomSpheres, testing::Values(2000, 8000, 32000));

}  // namespace
}  // namespace stipple
