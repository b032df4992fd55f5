#include "app/document/stroke.h"

#include <gmock/gmock.h>

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

// Five points a unit apart on a line far from 0, the third of them twice, on a double origin.
PointSet line() {
  return PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {2, 0, 0}}, {1000, 0, 0});
}

Stroke paint(std::string attribute, std::vector<double> value) {
  return {.attribute = std::move(attribute),
          .value = std::move(value),
          .radius = 1.5,
          .dabs = {{{1002, 0.3, 0}, 1}}};
}

PointSet apply(const PointSet& points, const Stroke& stroke) {
  Progress progress;
  return applyStroke(points, stroke, progress);
}

// (1 - t^2)^2 at t = 1 / 1.5.
constexpr double kRim = 25.0 / 81.0;

TEST(Stroke, LabelsAreSetWithinTheRadius) {
  const PointSet painted = apply(line(), paint("seeds", {7}));
  EXPECT_THAT(painted.values<std::int32_t>("seeds"), ElementsAre(0, 7, 7, 7, 0, 7));
}

TEST(Stroke, FloatsBlendWithTheFalloff) {
  PointSet points = line();
  points.set("height", std::vector<float>(6, 1.0f));
  const PointSet painted = apply(points, paint("height", {3}));
  const auto height = painted.values<float>("height");
  EXPECT_EQ(height[0], 1);
  EXPECT_FLOAT_EQ(height[1], 1 + 2 * kRim);
  EXPECT_EQ(height[2], 3);
  EXPECT_EQ(height[5], 3);
  EXPECT_EQ(points.values<float>("height")[2], 1) << "the points given stay as they are";
}

TEST(Stroke, StrengthAndPressureScaleWhatADabLaysDown) {
  PointSet points = line();
  points.set("height", std::vector<float>(6, 0.0f));
  Stroke stroke = paint("height", {8});
  stroke.strength = 0.5;
  stroke.dabs[0].pressure = 0.5;
  EXPECT_FLOAT_EQ(apply(points, stroke).values<float>("height")[2], 2);
  stroke.dabs.push_back(stroke.dabs[0]);
  EXPECT_FLOAT_EQ(apply(points, stroke).values<float>("height")[2], 2 + 0.25 * 6);
  for (Dab& dab : stroke.dabs) dab.pressure = 0;
  EXPECT_EQ(apply(points, stroke).values<float>("height")[2], 0);
}

TEST(Stroke, SizeScalesTheRadius) {
  Stroke stroke = paint("seeds", {7});
  stroke.dabs[0].size = 0.5;
  EXPECT_THAT(apply(line(), stroke).values<std::int32_t>("seeds"), ElementsAre(0, 0, 7, 0, 0, 7));
}

TEST(Stroke, ADabFartherFromTheSurfaceThanItsRadiusTouchesNothing) {
  Stroke stroke = paint("seeds", {7});
  stroke.dabs = {{.position = {1002, 1.4, 0}}};
  EXPECT_THAT(apply(line(), stroke).values<std::int32_t>("seeds"), ElementsAre(0, 7, 7, 7, 0, 7));
  stroke.dabs = {{.position = {1002, 1.6, 0}}};
  EXPECT_THAT(apply(line(), stroke).values<std::int32_t>("seeds"), ElementsAre(0, 0, 0, 0, 0, 0));
}

TEST(Stroke, ColorsBlendAndVectorsToo) {
  PointSet points = line();
  points.set("color", std::vector<Rgba8>(6, Rgba8{0, 0, 0, 255}));
  points.set("flow", std::vector<Eigen::Vector3f>(6, Eigen::Vector3f::Zero()));
  const auto painted = apply(apply(points, paint("color", {255, 0, 81})), paint("flow", {0, 0, 81}));
  EXPECT_EQ(painted.values<Rgba8>("color")[2], (Rgba8{255, 0, 81, 255}));
  EXPECT_EQ(painted.values<Rgba8>("color")[1], (Rgba8{79, 0, 25, 255}));  // 255 * 25/81 = 78.7
  EXPECT_FLOAT_EQ(painted.values<Eigen::Vector3f>("flow")[1].z(), 25);
}

TEST(Stroke, ErasingPaintsZeroOrWhite) {
  PointSet points = line();
  points.set("seeds", std::vector<std::int32_t>(6, 4));
  points.set("color", std::vector<Rgba8>(6, Rgba8{1, 2, 3, 255}));
  Stroke stroke = paint("seeds", {});
  stroke.tool = StrokeTool::kErase;
  EXPECT_THAT(apply(points, stroke).values<std::int32_t>("seeds"), ElementsAre(4, 0, 0, 0, 4, 0));
  stroke.attribute = "color";
  EXPECT_EQ(apply(points, stroke).values<Rgba8>("color")[2], (Rgba8{255, 255, 255, 255}));
  stroke.attribute = "height";
  EXPECT_THAT([&] { apply(points, stroke); }, ThrowsMessage<InvalidInput>(HasSubstr("'height'")));
}

TEST(Stroke, NewAttributesSuitTheirValue) {
  EXPECT_EQ(apply(line(), paint("a", {2})).find("a")->type(), AttributeType::kInt);
  EXPECT_EQ(apply(line(), paint("a", {2.5})).find("a")->type(), AttributeType::kFloat);
  EXPECT_EQ(apply(line(), paint("a", {1, 2, 3})).find("a")->type(), AttributeType::kColor);
}

TEST(Stroke, RefusesValuesThatDoNotSuit) {
  PointSet points = line();
  points.set("label", std::vector<std::uint32_t>(6, 0), {.name = "label", .type = ScalarType::kUint8});
  points.set("color", std::vector<Rgba8>(6, Rgba8{}));
  const auto painting = [&](std::string name, std::vector<double> value) {
    return [&points, stroke = paint(std::move(name), std::move(value))] { apply(points, stroke); };
  };
  EXPECT_THAT(painting("label", {256}), ThrowsMessage<InvalidInput>(HasSubstr("from 0 to 255")));
  EXPECT_THAT(painting("label", {1.5}), ThrowsMessage<InvalidInput>(HasSubstr("whole number")));
  EXPECT_THAT(painting("color", {1}), ThrowsMessage<InvalidInput>(HasSubstr("3 or 4 whole numbers")));
  EXPECT_THAT(painting("a", {1, 2}), ThrowsMessage<InvalidInput>(HasSubstr("1 number")));
}

TEST(Stroke, StopsWhenAskedTo) {
  struct Stopped final : Progress {
    bool cancelled() const override { return true; }
  } stopped;
  EXPECT_THROW(applyStroke(line(), paint("seeds", {1}), stopped), Cancelled);
}

}  // namespace
}  // namespace stipple
