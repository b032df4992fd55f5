#include "plugins/bump_mapping/bump_mapping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/cancel_after.h"
#include "tests/support/identical.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::ThrowsMessage;
using Settings = std::vector<std::pair<std::string, ParameterValue>>;

Parameters settingsOf(const Settings& settings) {
  Parameters parameters(makeBumpMapping()->description().parameters);
  parameters.set("attribute", std::string("height"));
  for (const auto& [id, value] : settings) parameters.set(id, value);
  return parameters;
}

PointSet bump(const PointSet& points, const Settings& settings, Report* report = nullptr) {
  const auto run = makeBumpMapping()->start(points, {}, settingsOf(settings));
  Progress progress;
  EXPECT_TRUE(run->step(progress).finished);
  if (report) *report = run->report();
  return run->result().points;
}

PointSet slope() {
  PointSet points(shapes::randomSquare(3000));
  std::vector<float> heights;
  for (const Eigen::Vector3f& p : points.positions()) heights.push_back(3 * p.x());
  points.set("height", heights);
  points.set("normal", std::vector<Eigen::Vector3f>(points.size(), {0, 0, 1}));
  return points;
}

// The gradient of 3 x is (3, 0, 0) everywhere, so its 95 % quantile is 3.
TEST(BumpMapping, TiltsALinearSlopeByTheStrength) {
  const PointSet points = slope();
  for (const double strength : {-1.0, 0.1, 0.5}) {
    for (const bool normalize : {false, true}) {
      const PointSet result = bump(points, {{"strength", strength}, {"normalize", normalize}});
      const double tilt = normalize ? strength : 3 * strength;
      const Eigen::Vector3f wanted = Eigen::Vector3d(-tilt, 0, 1).normalized().cast<float>();
      for (const Eigen::Vector3f& n : result.values<Eigen::Vector3f>("display_normal"))
        EXPECT_LT((n - wanted).norm(), 2e-3f);
    }
  }
}

TEST(BumpMapping, BumpsOfAHeightOnASphereStandOut) {
  PointSet points(shapes::randomSphere(10000));
  std::vector<float> heights;
  for (const Eigen::Vector3f& p : points.positions()) heights.push_back(std::exp(-20 * (1 - p.x())));
  points.set("height", heights);
  for (const char* gradient : {"fan", "radial"}) {
    const PointSet result = bump(points, {{"gradient", std::string(gradient)}});
    const auto normals = result.values<Eigen::Vector3f>("display_normal");
    for (Index i = 0; i < points.size(); ++i) {
      const Eigen::Vector3f& p = points.positions()[i];
      EXPECT_NEAR(normals[i].norm(), 1, 1e-5);
      EXPECT_GT(normals[i].dot(p), 0.3f) << "outward, whatever the fans say";
      // Beside the bump normals lean away from its top.
      if (p.x() > 0.85f && p.x() < 0.97f) {
        EXPECT_LT(normals[i].x(), p.x());
      }
    }
  }
}

TEST(BumpMapping, ShowsOnlyUnlessBaked) {
  const PointSet points = slope();
  PointSet shown = bump(points, {});
  EXPECT_TRUE(shown.erase("display_normal"));
  EXPECT_TRUE(identical(shown, points));
  const PointSet baked = bump(points, {{"bake", true}});
  EXPECT_TRUE(std::ranges::equal(baked.values<Eigen::Vector3f>("normal"),
                                 baked.values<Eigen::Vector3f>("display_normal")));
}

TEST(BumpMapping, ALargerRadiusIsSofter) {
  PointSet points(shapes::randomSquare(4000));
  std::vector<float> heights;
  for (const Eigen::Vector3f& p : points.positions()) heights.push_back(std::sin(60 * p.x()));
  points.set("height", heights);
  const auto tilt = [&](double radius) {
    double sum = 0;
    const PointSet result = bump(
        points,
        {{"gradient", std::string("radial")}, {"radius", radius}, {"normalize", false}, {"strength", 0.01}});
    for (const Eigen::Vector3f& n : result.values<Eigen::Vector3f>("display_normal"))
      sum += n.head<2>().norm();
    return sum / 4000;
  };
  EXPECT_GT(tilt(0.03), 1.5 * tilt(0.1));
}

TEST(BumpMapping, AnotherStrengthActsAtTheNextStepAndCancelChangesNothing) {
  const PointSet points = slope();
  const auto run = makeBumpMapping()->start(points, {}, settingsOf({}));
  CancelAfter cancel(0);
  EXPECT_THROW(run->step(cancel), Cancelled);
  EXPECT_TRUE(identical(run->result().points, points));
  Progress progress;
  run->step(progress);
  run->set(settingsOf({{"strength", -0.5}}));
  run->step(progress);
  EXPECT_TRUE(identical(run->result().points, bump(points, {{"strength", -0.5}})));
  run->set(settingsOf({{"gradient", std::string("radial")}}));
  run->step(progress);
  EXPECT_TRUE(identical(run->result().points, bump(points, {{"gradient", std::string("radial")}})));
}

TEST(BumpMapping, OddInputEndsWell) {
  PointSet points = slope();
  points.edit<float>("height")[7] = std::numeric_limits<float>::quiet_NaN();
  for (const char* gradient : {"fan", "radial"}) {
    const PointSet result = bump(points, {{"gradient", std::string(gradient)}});
    for (const Eigen::Vector3f& n : result.values<Eigen::Vector3f>("display_normal"))
      EXPECT_TRUE(n.allFinite());
  }
  PointSet one(std::vector<Eigen::Vector3f>{{1, 2, 3}});
  one.set("height", std::vector<float>{2});
  Report report;
  EXPECT_TRUE(bump(one, {}, &report).values<Eigen::Vector3f>("display_normal")[0].allFinite());
  EXPECT_THAT(report.warnings.at(0), HasSubstr("no relief"));
  EXPECT_THAT(
      [&] {
        bump(points, {{"attribute", std::string("normal")}});
      },
      ThrowsMessage<InvalidInput>(HasSubstr("is a vector3, expected a number")));
}

TEST(BumpMapping, DeclaresWhatTheContractPromises) {
  const auto bumps = makeBumpMapping();
  std::vector<std::string> ids;
  for (const Parameter& parameter : bumps->description().parameters) ids.push_back(parameter.id);
  EXPECT_EQ(bumps->description().id, "bump_mapping");
  EXPECT_THAT(ids,
              IsSupersetOf({"attribute", "strength", "gradient", "radius", "normalize", "bake", "scheme"}));
  EXPECT_NO_THROW(checkDeclarations(bumps->description().parameters));
}

}  // namespace
}  // namespace stipple
