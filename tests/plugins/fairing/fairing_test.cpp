#include "plugins/fairing/fairing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/geometry/discretization.h"
#include "core/parallel.h"
#include "plugins/fairing/resampling.h"
#include "tests/plugins/fairing/faired.h"
#include "tests/support/cancel_after.h"
#include "tests/support/identical.h"
#include "tests/support/shapes.h"
#include "tests/support/undoable.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

double meanRadius(const PointSet& points) {
  double sum = 0;
  for (const Eigen::Vector3f& p : points.positions()) sum += p.cast<double>().norm();
  return sum / points.size();
}

// An even spiral on the unit sphere.
std::vector<Eigen::Vector3f> spiral(int count) {
  std::vector<Eigen::Vector3f> points;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    points.push_back(Eigen::Vector3d(r * std::cos(golden * i), r * std::sin(golden * i), z).cast<float>());
  }
  return points;
}

// A plane with noise, random points of the unit square.
PointSet roughSquare(double noise) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSquare(4000);
  std::mt19937_64 random(3);
  std::normal_distribution<float> normal(0, static_cast<float>(noise / std::sqrt(4000.0)));
  for (Eigen::Vector3f& p : positions) p.z() = normal(random);
  return PointSet(positions);
}

double roughness(const PointSet& points) {
  double sum = 0;
  for (const Eigen::Vector3f& p : points.positions()) sum += p.z() * p.z();
  return std::sqrt(sum / points.size());
}

// Under mean curvature flow R' = -2 / R. The implicit step is of first order: smaller steps are closer.
TEST(Fairing, ASphereShrinksAsMeanCurvatureFlowSays) {
  const PointSet points(spiral(10'000));
  const double h2 = 4 * std::numbers::pi / 10'000;
  for (const double timeStep : {0.25, 1.0}) {
    const PointSet result = faired(
        points, {{"tensor", std::string("isotropic")}, {"time_step", timeStep}, {"steps", std::int64_t{5}}});
    const double wanted = std::sqrt(1 - 4 * 5 * timeStep * h2);
    EXPECT_NEAR(meanRadius(result) / wanted, 1, 0.0005) << timeStep;
    EXPECT_LT(wanted, timeStep < 1 ? 0.998 : 0.99) << "nothing to see";
  }
}

TEST(Fairing, KeepsTheVolumeWhereAskedTo) {
  const PointSet points(spiral(5000));
  const Settings settings{{"tensor", std::string("isotropic")}, {"time_step", 1.0}, {"volume", true}};
  EXPECT_NEAR(meanRadius(faired(points, settings)), 1, 2e-4);
}

TEST(Fairing, DisplacementIsSignedAlongTheNormal) {
  const PointSet points(spiral(5000));
  const PointSet result = faired(points, {{"tensor", std::string("isotropic")}, {"time_step", 1.0}});
  for (Index row = 0; row < points.size(); ++row) {
    const double moved = result.positions()[row].norm() - points.positions()[row].norm();
    ASSERT_NEAR(result.values<float>("displacement")[row], moved, 2e-5) << "outwards is positive";
    ASSERT_GT(result.values<Eigen::Vector3f>("normal")[row].dot(points.positions()[row]), 0.99f);
  }
}

TEST(Fairing, FlattensARoughPlaneAndPinsItsRim) {
  const PointSet points = roughSquare(0.3);
  const PointSet pinned = faired(points), loose = faired(points, {{"pin_boundary", false}});
  EXPECT_LT(roughness(pinned), 0.35 * roughness(points));
  Progress progress;
  const Discretization d = discretize(points, {.metric = Metric::kProjected}, progress);
  Index rim = 0;
  for (Index row = 0; row < points.size(); ++row) {
    if (!d.fans.open[d.sites.siteOfPoint[row]]) continue;
    ++rim;
    EXPECT_EQ(pinned.positions()[row], points.positions()[row]);
  }
  EXPECT_GT(rim, 100u);
  const auto width = [](const PointSet& set) {
    float least = 1, most = 0;
    for (const Eigen::Vector3f& p : set.positions())
      least = std::min(least, p.x()), most = std::max(most, p.x());
    return most - least;
  };
  EXPECT_LT(width(loose), width(points));
}

TEST(Fairing, ChangesNothingOutsideOfItsRegion) {
  PointSet points = roughSquare(0.3);
  points.set("normal", std::vector<Eigen::Vector3f>(points.size(), {0, 0, 1}));
  std::vector<std::uint8_t> mask(points.size());
  for (Index row = 0; row < points.size(); ++row) mask[row] = points.positions()[row].x() < 0.5f;
  const PointSet result = faired(points, {}, Region(points, mask));
  Index moved = 0;
  for (Index row = 0; row < points.size(); ++row) {
    if (mask[row]) {
      moved += result.positions()[row] != points.positions()[row];
      continue;
    }
    ASSERT_EQ(result.positions()[row], points.positions()[row]);
    ASSERT_EQ(result.values<Eigen::Vector3f>("normal")[row], Eigen::Vector3f(0, 0, 1));
    ASSERT_EQ(result.values<float>("displacement")[row], 0);
  }
  EXPECT_GT(moved, 1500u);
}

TEST(Fairing, WeightsScaleWhatMoves) {
  PointSet points = roughSquare(0.3);
  std::vector<float> weights(points.size());
  for (Index row = 0; row < points.size(); ++row) weights[row] = points.positions()[row].x() < 0.5f ? 0 : 1;
  points.set("soft", weights);
  const PointSet result = faired(points, {{"weight_by", std::string("soft")}});
  for (Index row = 0; row < points.size(); ++row) {
    if (weights[row] != 0) continue;
    ASSERT_EQ(result.positions()[row], points.positions()[row]);
  }
  EXPECT_LT(roughness(result), 0.85 * roughness(points));
  EXPECT_THAT(
      [&] {
        makeFairing()->start(points, {}, fairingSettings({{"weight_by", std::string("none2")}}));
      },
      ThrowsMessage<InvalidInput>(HasSubstr("there is no attribute \"none2\"")));
}

TEST(Fairing, IsUndoneBitForBit) {
  const PointSet points = roughSquare(0.3);
  expectUndoable(points, {.points = faired(points)});
}

TEST(Fairing, CopiesStayTogetherAndOddSetsStayFinite) {
  std::vector<Eigen::Vector3f> twice = shapes::randomSphere(2000), line, copies(50, Eigen::Vector3f(1, 2, 3));
  twice.insert(twice.end(), twice.begin(), twice.begin() + 700);
  for (int i = 0; i < 60; ++i) line.emplace_back(static_cast<float>(i), 0, 0);
  const PointSet welded = faired(PointSet(twice));
  for (Index row = 0; row < 700; ++row) ASSERT_EQ(welded.positions()[row], welded.positions()[2000 + row]);
  std::vector<std::vector<Eigen::Vector3f>> sets{line, copies};
  for (std::size_t count = 1; count < 8; ++count) sets.push_back(shapes::randomSphere(count));
  for (const auto& set : sets) {
    for (const char* tensor : {"features", "paper", "isotropic"}) {
      const PointSet result = faired(PointSet(set), {{"tensor", std::string(tensor)}});
      for (const Eigen::Vector3f& p : result.positions()) ASSERT_TRUE(p.allFinite());
      for (const Eigen::Vector3f& n : result.values<Eigen::Vector3f>("normal")) ASSERT_TRUE(n.allFinite());
    }
  }
}

TEST(Fairing, KeepsTheOriginAndFarCoordinates) {
  std::vector<Eigen::Vector3f> near = spiral(3000);
  const PointSet here(near), there(near, {5e6, -3e6, 0}, ScalarType::kFloat64);
  const PointSet a = faired(here), b = faired(there);
  EXPECT_EQ(b.origin(), there.origin());
  for (Index row = 0; row < a.size(); ++row) ASSERT_EQ(a.positions()[row], b.positions()[row]);
}

TEST(Fairing, ParametersActAtTheNextStepAndACancelledStepDoesNothing) {
  class Stop final : public Progress {
    bool cancelled() const override { return true; }
  } stop;
  const PointSet points = roughSquare(0.3);
  const auto run = makeFairing()->start(points, {}, fairingSettings({{"steps", std::int64_t{3}}}));
  Progress progress;
  EXPECT_THROW(run->step(stop), Cancelled);
  EXPECT_TRUE(identical(run->result().points, points));
  EXPECT_FALSE(run->step(progress).finished);
  const PointSet first = run->result().points;
  run->set(fairingSettings({{"steps", std::int64_t{2}}, {"tensor", std::string("isotropic")}}));
  EXPECT_THROW(run->step(stop), Cancelled);
  EXPECT_TRUE(identical(run->result().points, first));
  EXPECT_TRUE(run->step(progress).finished);
  EXPECT_FALSE(identical(run->result().points, first));
}

// A sphere that shrinks to a third of its area keeps about the density it had, and what its points carry.
TEST(Fairing, ResamplingKeepsTheDensity) {
  PointSet points(spiral(3000));
  std::vector<float> heights;
  for (const Eigen::Vector3f& p : points.positions()) heights.push_back(p.z());
  points.set("height", heights);
  points.set("label", std::vector<std::int32_t>(3000, 4));
  const Settings settings{{"tensor", std::string("isotropic")},
                          {"time_step", 0.5},
                          {"steps", std::int64_t{80}},
                          {"refresh", std::int64_t{1}}};
  Settings resampling = settings;
  resampling.emplace_back("resample", true);
  const auto run = makeFairing()->start(points, {}, fairingSettings(resampling));
  Progress progress;
  while (!run->step(progress).finished) {
  }
  const RunResult result = run->result();
  const double area = std::pow(meanRadius(result.points), 2);
  EXPECT_LT(area, 0.4);
  EXPECT_NEAR(result.points.size() / (3000 * area), 1, 0.35);
  EXPECT_EQ(faired(points, settings).size(), 3000u) << "off by default";
  for (Index row = 0; row < result.points.size(); ++row) {
    const Eigen::Vector3f& p = result.points.positions()[row];
    ASSERT_NEAR(result.points.values<float>("height")[row], p.z() / p.norm(), 0.05f);
    ASSERT_EQ(result.points.values<std::int32_t>("label")[row], 4);
  }
  expectUndoable(points, result);
}

// A part that is pulled out by volume that is kept elsewhere stretches: points come.
TEST(Fairing, ResamplingInsertsWhereTheSurfaceStretches) {
  Progress progress;
  const Discretization d = discretize(PointSet(spiral(1000)), {}, progress);
  std::vector<double> rest = localSpacings(d);
  for (double& spacing : rest) spacing /= 1.5;
  const Resampling plan = planResampling(d, rest);
  EXPECT_TRUE(plan.removed.empty());
  EXPECT_GT(plan.inserted.size(), 50u);
  for (double& spacing : rest) spacing = 0;
  EXPECT_TRUE(planResampling(d, rest).inserted.empty());
}

// Whenever it is stopped, the result is that of the step before.
TEST(Fairing, CanBeCancelledAnywhere) {
  const PointSet points(spiral(1500));
  const Settings settings{{"resample", true}, {"refresh", std::int64_t{1}}, {"time_step", 2.0}};
  bool isDone = false;
  for (int calls = 0; !isDone; calls += 3) {
    const auto run = makeFairing()->start(points, {}, fairingSettings(settings));
    Progress progress;
    run->step(progress);
    const RunResult first = run->result();
    try {
      CancelAfter limited(calls);
      run->step(limited);
      isDone = true;
    } catch (const Cancelled&) {
      ASSERT_TRUE(identical(run->result().points, first.points)) << calls;
      ASSERT_EQ(run->result().removedRows, first.removedRows);
    }
  }
}

TEST(Fairing, DoesNotDependOnTheThreads) {
  const PointSet points = roughSquare(0.3);
  const PointSet onAll = faired(points);
  const ThreadLimit one(1);
  EXPECT_TRUE(identical(onAll, faired(points)));
}

}  // namespace
}  // namespace stipple
