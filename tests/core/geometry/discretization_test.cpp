#include "core/geometry/discretization.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

Discretization discretized(std::vector<Eigen::Vector3f> points, const DiscretizationOptions& options = {}) {
  Progress progress;
  return discretize(PointSet(std::move(points)), options, progress);
}

double total(const std::vector<double>& mass) {
  return std::accumulate(mass.begin(), mass.end(), 0.0);
}

TEST(Discretization, MassAddsUpToTheArea) {
  constexpr double kSphere = 4 * 3.14159265358979;
  for (const bool consensus : {true, false}) {
    for (const Scheme scheme : {Scheme::kVoronoi, Scheme::kElement, Scheme::kPaper}) {
      const auto d = discretized(shapes::randomSphere(20000), {.scheme = scheme, .consensus = consensus});
      EXPECT_NEAR(total(d.mass), kSphere, 0.003 * kSphere);
    }
  }
  // A square up to its rim, where a third of the triangles is counted.
  EXPECT_NEAR(total(discretized(shapes::grid(101)).mass), 1, 1e-4);
}

TEST(Discretization, SchemeMeshTakesTheTrianglesOfTheFile) {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  points.setTriangles({{0, 1, 2}, {1, 3, 2}});
  Progress progress;
  const Discretization d = discretize(points, {.scheme = Scheme::kMesh}, progress);
  EXPECT_NEAR(total(d.mass), 1, 1e-12);
  EXPECT_THROW(discretize(PointSet({{0, 0, 0}}), {.scheme = Scheme::kMesh}, progress), InvalidInput);
}

TEST(Discretization, RefusesWhatItCannotDo) {
  Progress progress;
  EXPECT_THROW(discretize(PointSet(), {}, progress), InvalidInput);
  const PointSet points(shapes::randomSphere(100));
  EXPECT_THROW(discretize(points, {.k = 3}, progress), InvalidInput);
  EXPECT_THROW(discretize(points, {.minAngle = 0.3}, progress), InvalidInput);
  EXPECT_THROW(discretize(PointSet({{0, 0, 0}, {1e30f, 0, 0}, {0, 1e30f, 0}}), {}, progress), InvalidInput);
  EXPECT_NO_THROW(discretize(points, {.scheme = Scheme::kPaper, .minAngle = 0.3}, progress));
}

// Every one of these has a result: finite weights >= 0, positive masses.
TEST(Discretization, DegenerateSetsHaveAResult) {
  std::vector<std::vector<Eigen::Vector3f>> sets;
  for (const std::size_t n : {1u, 2u, 3u, 4u, 5u}) sets.push_back(shapes::randomSphere(n));
  sets.emplace_back(5000, Eigen::Vector3f(1, 2, 3));
  std::vector<Eigen::Vector3f> line, sheets = shapes::grid(60);
  for (int i = 0; i < 300; ++i)
    line.emplace_back(0.1f * static_cast<float>(i), 0.2f * static_cast<float>(i), 0.f);
  sets.push_back(line);
  for (const auto& p : shapes::grid(60)) sheets.push_back(p + Eigen::Vector3f(0, 0, 0.5f / 59));
  sets.push_back(sheets);
  sets.push_back(shapes::grid(40));
  auto twice = shapes::randomSphere(500);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 250);
  sets.push_back(twice);
  for (const float scale : {1e-8f, 1e8f}) {
    auto scaled = shapes::randomSphere(300);
    for (auto& p : scaled) p *= scale;
    sets.push_back(scaled);
  }
  for (const auto& points : sets) {
    for (const Scheme scheme : {Scheme::kVoronoi, Scheme::kElement, Scheme::kPaper}) {
      for (const Metric metric : {Metric::kUnfolded, Metric::kProjected}) {
        for (const bool consensus : {true, false}) {
          const auto d = discretized(points, {.scheme = scheme, .metric = metric, .consensus = consensus});
          for (const double m : d.mass) ASSERT_TRUE(std::isfinite(m) && m > 0) << points.size();
          for (const double w : d.weights) {
            ASSERT_TRUE(std::isfinite(w)) << points.size();
            ASSERT_TRUE(scheme == Scheme::kPaper || w >= 0) << points.size();
          }
        }
      }
    }
  }
}

TEST(Discretization, PointsOnALineMakeAChain) {
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 50; ++i) line.emplace_back(static_cast<float>(i), 0.f, 0.f);
  const auto d = discretized(line);
  for (Index i = 0; i < d.size(); ++i) {
    for (const Index j : d.fans.of(i))
      EXPECT_NEAR((d.sites.positions[i] - d.sites.positions[j]).norm(), 1, 1e-5);
    EXPECT_GE(d.fans.of(i).size(), 1u);
  }
}

TEST(Discretization, ProjectedMetricIgnoresNoiseAcrossTheSurface) {
  auto points = shapes::randomSphere(8000, 2);
  const double spacing = std::sqrt(4 * 3.14159265 / 8000);
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal(0, 0.3 * spacing);
  for (auto& p : points) p *= static_cast<float>(1 + normal(random));
  const double area = 4 * 3.14159265;
  const double projected =
      total(discretized(points, {.metric = Metric::kProjected, .consensus = false}).mass);
  const double unfolded = total(discretized(points, {.consensus = false}).mass);
  EXPECT_NEAR(projected, area, 0.05 * area);
  EXPECT_GT(unfolded, 1.08 * area);
}

}  // namespace
}  // namespace stipple
