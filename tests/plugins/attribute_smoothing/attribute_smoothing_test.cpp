#include "plugins/attribute_smoothing/attribute_smoothing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/io/point_io.h"
#include "tests/support/cancel_after.h"
#include "tests/support/creased_shapes.h"
#include "tests/support/identical.h"
#include "tests/support/shapes.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::ThrowsMessage;
using Settings = std::vector<std::pair<std::string, ParameterValue>>;

Parameters settingsOf(const Settings& settings) {
  Parameters parameters(makeAttributeSmoothing()->description().parameters);
  for (const auto& [id, value] : settings) parameters.set(id, value);
  return parameters;
}

PointSet smooth(const PointSet& points, const Settings& settings, const Region& region = {}) {
  const auto run = makeAttributeSmoothing()->start(points, region, settingsOf(settings));
  Progress progress;
  while (!run->step(progress).finished) {
  }
  return run->result().points;
}

// Heat on the unit sphere: z, of eigenvalue 2, decays by 1 / (1 + 2 tau) in each implicit step.
TEST(AttributeSmoothing, HeatDecaysAsOnTheSphere) {
  PointSet points(shapes::randomSphere(8000));
  std::vector<double> z;
  for (const Eigen::Vector3f& p : points.positions()) z.push_back(p.z());
  points.set("z", z);
  const PointSet result = smooth(points, {{"attribute", std::string("z")}, {"time_step", 40.0}});
  const double tau = 40 * 4 * std::numbers::pi / 8000, wanted = std::pow(1 + 2 * tau, -10);
  double product = 0, square = 0;
  for (Index i = 0; i < points.size(); ++i) {
    product += result.values<double>("z")[i] * z[i];
    square += z[i] * z[i];
  }
  EXPECT_NEAR(product / square, wanted, 0.02 * wanted);
}

TEST(AttributeSmoothing, ConstantsStayAndExtremesShrink) {
  PointSet points(shapes::randomSquare(4000));
  std::mt19937 random(4);
  std::vector<Rgba8> colors;
  for (Index i = 0; i < points.size(); ++i)
    colors.push_back({static_cast<std::uint8_t>(random() % 256), 77, 200, static_cast<std::uint8_t>(i)});
  points.set("color", colors);
  for (const char* method : {"heat", "edge_preserving"}) {
    const PointSet result = smooth(points, {{"method", std::string(method)}, {"time_step", 1.0}});
    int least = 255, greatest = 0;
    for (Index i = 0; i < points.size(); ++i) {
      const Rgba8 color = result.values<Rgba8>("color")[i];
      EXPECT_EQ(color.g, 77);
      EXPECT_EQ(color.a, colors[i].a);
      least = std::min<int>(least, color.r);
      greatest = std::max<int>(greatest, color.r);
    }
    // Single points that stand out may pass for edges.
    const int shrunk = method == std::string("heat") ? 20 : 1;
    EXPECT_GE(least, shrunk) << method;
    EXPECT_LE(greatest, 255 - shrunk) << method;
  }
}

// A noisy step: both methods remove the noise, one of them the step too.
TEST(AttributeSmoothing, EdgePreservingKeepsWhatHeatWashesOut) {
  PointSet points(shapes::randomSquare(10000));
  std::mt19937_64 random(2);
  std::normal_distribution<float> noise(0, 0.05f);
  std::vector<float> values;
  for (const Eigen::Vector3f& p : points.positions())
    values.push_back((p.x() > 0.5f ? 1.f : 0.f) + noise(random));
  points.set("value", values);
  const auto errors = [&](const char* method) {
    const PointSet result = smooth(
        points, {{"attribute", std::string("value")}, {"method", std::string(method)}, {"time_step", 1.0}});
    double far = 0, farCount = 0, near = 0, nearCount = 0;
    for (Index i = 0; i < points.size(); ++i) {
      const float x = points.positions()[i].x();
      const double error = result.values<float>("value")[i] - (x > 0.5f ? 1 : 0), away = std::abs(x - 0.5f);
      if (away > 0.2f) far += error * error, ++farCount;
      if (away > 0.015f && away < 0.05f) near += error * error, ++nearCount;
    }
    return std::pair(std::sqrt(far / farCount), std::sqrt(near / nearCount));
  };
  const auto [heatFar, heatNear] = errors("heat");
  const auto [keptFar, keptNear] = errors("edge_preserving");
  EXPECT_LT(heatFar, 0.02);
  EXPECT_LT(keptFar, 0.025);
  EXPECT_LT(keptNear, 0.6 * heatNear);
}

TEST(AttributeSmoothing, NothingCrossesABlockedCrease) {
  const shapes::FacedPoints fold = shapes::foldedSquare(std::numbers::pi / 2, 4900, 1);
  PointSet points(fold.positions);
  points.set("side", std::vector<float>(fold.faces.begin(), fold.faces.end()));
  const auto leaked = [&](bool blocks) {
    const PointSet result =
        smooth(points, {{"attribute", std::string("side")}, {"time_step", 20.0}, {"block_creases", blocks}});
    double sum = 0;
    for (Index i = 0; i < points.size(); ++i)
      sum += std::abs(result.values<float>("side")[i] - static_cast<float>(fold.faces[i]));
    return sum / 4900;
  };
  EXPECT_LT(leaked(true), 0.01);
  EXPECT_GT(leaked(false), 0.05);
}

TEST(AttributeSmoothing, ChangesNothingOutsideTheRegion) {
  PointSet points(shapes::randomSphere(3000));
  std::vector<Eigen::Vector3f> vectors(points.positions().begin(), points.positions().end());
  points.set("along", vectors);
  std::vector<std::uint8_t> mask;
  for (const Eigen::Vector3f& p : points.positions()) mask.push_back(p.z() > 0);
  const PointSet result =
      smooth(points, {{"attribute", std::string("along")}, {"time_step", 10.0}}, Region(points, mask));
  int changed = 0;
  for (Index i = 0; i < points.size(); ++i) {
    const bool differs = result.values<Eigen::Vector3f>("along")[i] != vectors[i];
    if (!mask[i]) {
      EXPECT_FALSE(differs);
    }
    changed += differs;
  }
  EXPECT_GT(changed, 1000);
}

TEST(AttributeSmoothing, ValuesThatAreNoneTakeNoPart) {
  PointSet points(shapes::grid(20));
  std::vector<float> values(400, 3.f);
  values[210] = std::numeric_limits<float>::infinity();
  points.set("value", values);
  for (const char* method : {"heat", "edge_preserving"}) {
    const PointSet result =
        smooth(points, {{"attribute", std::string("value")}, {"method", std::string(method)}});
    for (Index i = 0; i < 400; ++i) {
      if (i == 210) continue;
      EXPECT_NEAR(result.values<float>("value")[i], 3, 1e-5);
    }
    EXPECT_TRUE(std::isinf(result.values<float>("value")[210]));
  }
}

TEST(AttributeSmoothing, ParametersActAtTheNextStep) {
  PointSet points(shapes::randomSquare(2000));
  std::vector<float> values;
  for (const Eigen::Vector3f& p : points.positions()) values.push_back(std::sin(30 * p.x()));
  points.set("value", values);
  const auto run = makeAttributeSmoothing()->start(
      points, {}, settingsOf({{"attribute", std::string("value")}, {"time_step", 0.01}}));
  Progress progress;
  const StepState slow = run->step(progress);
  EXPECT_FALSE(slow.finished);
  const PointSet before = run->result().points;
  CancelAfter cancel(0);
  EXPECT_THROW(run->step(cancel), Cancelled);
  EXPECT_TRUE(identical(before, run->result().points));
  run->set(settingsOf({{"attribute", std::string("value")}, {"time_step", 5.0}, {"steps", std::int64_t{3}}}));
  const StepState fast = run->step(progress);
  EXPECT_GT(*fast.curve, 10 * *slow.curve) << "goes on from where it was";
  EXPECT_TRUE(run->step(progress).finished);
}

// Coarse, thin and sharp: the weights of scheme paper are indefinite on it, those of its file once edges of
// the attribute divide them.
TEST(AttributeSmoothing, EverySchemeKeepsToTheRangeOnACasting) {
  STIPPLE_NEEDS_TEST_DATA();
  Progress progress;
  PointSet points = readPoints(testData("cad/casting.off"), progress).points;
  std::mt19937 random(2);
  std::vector<float> noise(points.size());
  for (float& value : noise) value = static_cast<float>(random() % 1000) / 999;
  points.set("noise", noise);
  for (const char* scheme : {"voronoi", "element", "paper", "mesh"}) {
    for (const char* method : {"heat", "edge_preserving"}) {
      const PointSet result = smooth(points, {{"attribute", std::string("noise")},
                                              {"scheme", std::string(scheme)},
                                              {"method", std::string(method)},
                                              {"time_step", 4.0}});
      const auto [least, greatest] = std::ranges::minmax(result.values<float>("noise"));
      // Whole triangles of the file may have cotangents below 0: semidefinite, but no maximum principle.
      const float beyond = scheme == std::string("mesh") && method == std::string("heat") ? 0.5f : 1e-4f;
      EXPECT_GE(least, -beyond) << scheme << " " << method;
      EXPECT_LE(greatest, 1 + beyond) << scheme << " " << method;
    }
  }
}

TEST(AttributeSmoothing, SaysWhatItCannotDoAndEndsQuietlyOnDegenerateSets) {
  PointSet points(shapes::grid(4));
  EXPECT_THAT([&] { smooth(points, {}); }, ThrowsMessage<InvalidInput>(HasSubstr("no attribute \"color\"")));
  for (const auto& positions :
       {std::vector<Eigen::Vector3f>{{0, 0, 0}}, std::vector<Eigen::Vector3f>(9, {1, 1, 1}),
        std::vector<Eigen::Vector3f>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}) {
    PointSet few(positions);
    few.set("color", std::vector<Rgba8>(positions.size(), Rgba8{9, 9, 9, 255}));
    for (const char* method : {"heat", "edge_preserving"})
      EXPECT_TRUE(identical(smooth(few, {{"method", std::string(method)}, {"block_creases", true}}), few));
  }
}

TEST(AttributeSmoothing, DeclaresWhatTheContractPromises) {
  const auto smoothing = makeAttributeSmoothing();
  EXPECT_EQ(smoothing->description().id, "attribute_smoothing");
  EXPECT_EQ(smoothing->description().region, RegionUse::kLimits);
  std::vector<std::string> ids;
  for (const Parameter& parameter : smoothing->description().parameters) ids.push_back(parameter.id);
  EXPECT_THAT(ids, IsSupersetOf({"attribute", "steps", "time_step", "method", "block_creases", "scheme"}));
  EXPECT_NO_THROW(checkDeclarations(smoothing->description().parameters));
}

}  // namespace
}  // namespace stipple
