#include "app/document/stroke_painter.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/support/identical.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Three points a unit apart, the middle one twice: everybody is everybody's neighbor.
PointSet three() {
  return PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}});
}

Stroke strokeOn(std::string attribute, StrokeTool tool) {
  return {.tool = tool, .attribute = std::move(attribute), .value = {}, .radius = 0.5};
}

std::vector<Edit::Touched> layAt(PointSet& points, const Stroke& stroke, double x,
                                 const PointFilter& filter = {}) {
  const StrokePainter painter(std::make_shared<SurfaceDistance>(points), stroke);
  return painter.lay(points, {.position = {x, 0, 0}}, filter);
}

TEST(StrokePainter, LaysTheSameBitsDabByDab) {
  PointSet points(shapes::randomSphere(4000), {10, 20, 30});
  points.set("height", std::vector<float>(4000, 0.25f));
  points.set("color", std::vector<Rgba8>(4000, Rgba8{10, 200, 30, 255}));
  const auto surface = std::make_shared<SurfaceDistance>(points);
  std::vector<Dab> dabs;
  for (int d = 0; d < 30; ++d) {
    dabs.push_back(
        {.position = points.positions()[d].cast<double>() + points.origin(), .pressure = d / 29.0});
  }
  PointSet whole = points, byDab = points;
  for (Stroke stroke : {Stroke{.attribute = "height", .value = {3.7}, .radius = 0.4, .strength = 0.3},
                        Stroke{.attribute = "color", .value = {255, 0, 99}, .radius = 0.5, .strength = 0.7},
                        Stroke{.attribute = "seeds", .value = {4}, .radius = 0.2},
                        Stroke{.attribute = "color", .value = {1, 2, 3}, .radius = 1, .within = "seeds"},
                        strokeOn("height", StrokeTool::kSmooth), strokeOn("color", StrokeTool::kSmooth),
                        strokeOn("seeds", StrokeTool::kSmooth), strokeOn("seeds", StrokeTool::kErase)}) {
    const StrokePainter painter(surface, stroke);
    for (const Dab& dab : dabs) painter.lay(byDab, dab);
    stroke.dabs = dabs;
    Progress progress;
    whole = applyStroke(whole, stroke, progress);
    ASSERT_TRUE(identical(whole, byDab));
  }
  EXPECT_FALSE(identical(points, whole));
}

TEST(StrokePainter, TellsWhatItTouched) {
  PointSet points = three();
  Stroke stroke = strokeOn("seeds", StrokeTool::kPaint);
  stroke.value = {3};
  const auto first = layAt(points, stroke, 1);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].name, "seeds");
  EXPECT_EQ(first[0].rows, nullptr) << "it was made";
  EXPECT_EQ(points.find("seeds")->type(), AttributeType::kInt);
  EXPECT_THAT(*layAt(points, stroke, 1)[0].rows, ElementsAre(1, 3));
  EXPECT_THAT(points.values<std::int32_t>("seeds"), ElementsAre(0, 3, 0, 3));
}

TEST(StrokePainter, PaintsOnlyWithinAndThroughTheFilter) {
  PointSet points = three();
  points.set("mask", std::vector<float>{1, kNan, 0, 0.5f});
  Stroke stroke = strokeOn("seeds", StrokeTool::kPaint);
  stroke.value = {3};
  stroke.radius = 5;
  stroke.within = "mask";
  layAt(points, stroke, 1);
  EXPECT_THAT(points.values<std::int32_t>("seeds"), ElementsAre(3, 3, 0, 3)) << "NaN is not 0";
  stroke.value = {4};
  const auto touched = layAt(points, stroke, 1, [](Index point) { return point >= 2; });
  EXPECT_THAT(*touched[0].rows, ElementsAre(3));
  EXPECT_THAT(points.values<std::int32_t>("seeds"), ElementsAre(3, 3, 0, 4));
  EXPECT_THAT(layAt(points, stroke, 1, [](Index) { return false; }), IsEmpty());
  stroke.within = "hole";
  EXPECT_THAT([&] { layAt(points, stroke, 1); }, ThrowsMessage<InvalidInput>(HasSubstr("'hole'")));
}

TEST(StrokePainter, SmoothsTowardTheMeanOfTheNeighbors) {
  PointSet points = three();
  points.set("height", std::vector<float>{2, 0, 4, 0});
  points.set("color", std::vector<Rgba8>{{10, 0, 0, 255}, {}, {20, 0, 1, 255}, {}});
  points.set("flow", std::vector<Eigen::Vector3f>{{2, 0, 0}, {0, 0, 0}, {4, 0, 6}, {0, 0, 0}});
  Stroke stroke = strokeOn("height", StrokeTool::kSmooth);
  stroke.strength = 0.5;
  layAt(points, stroke, 1);
  EXPECT_THAT(points.values<float>("height"), ElementsAre(2, 1.5f, 4, 1.5f));
  layAt(points, strokeOn("color", StrokeTool::kSmooth), 1);
  EXPECT_EQ(points.values<Rgba8>("color")[1], (Rgba8{15, 0, 1, 255}));
  layAt(points, strokeOn("flow", StrokeTool::kSmooth), 1);
  EXPECT_EQ(points.values<Eigen::Vector3f>("flow")[3], Eigen::Vector3f(3, 0, 3));
}

TEST(StrokePainter, SmoothingTakesNoNumberFromNan) {
  PointSet points = three();
  points.set("height", std::vector<float>{kNan, 0, 4, 0});
  layAt(points, strokeOn("height", StrokeTool::kSmooth), 1);
  EXPECT_EQ(points.values<float>("height")[1], 4);
  points.set("height", std::vector<float>{kNan, 1, kNan, 1});
  layAt(points, strokeOn("height", StrokeTool::kSmooth), 1);
  EXPECT_EQ(points.values<float>("height")[1], 1);
}

TEST(StrokePainter, SmoothsLabelsToTheMajority) {
  PointSet points(shapes::grid(9));
  std::vector<std::int32_t> labels(81, 7);
  labels[40] = 2;
  points.set("label", labels);
  const StrokePainter painter(std::make_shared<SurfaceDistance>(points),
                              strokeOn("label", StrokeTool::kSmooth));
  painter.lay(points, {.position = {0.5, 0.5, 0}});
  EXPECT_EQ(points.values<std::int32_t>("label")[40], 7);
  PointSet pair({{0, 0, 0}, {1, 0, 0}});
  pair.set("label", std::vector<std::int32_t>{2, 1});
  layAt(pair, strokeOn("label", StrokeTool::kSmooth), 0);
  EXPECT_THAT(pair.values<std::int32_t>("label"), ElementsAre(2, 1)) << "one vote each: it keeps its own";
}

TEST(StrokePainter, OnlyPaintingMakesAttributes) {
  PointSet points = three();
  EXPECT_THAT([&] { layAt(points, strokeOn("height", StrokeTool::kSmooth), 1); },
              ThrowsMessage<InvalidInput>(HasSubstr("'height' to smooth")));
  PointSet none;
  Stroke stroke = strokeOn("seeds", StrokeTool::kPaint);
  stroke.value = {1};
  EXPECT_EQ(StrokePainter(nullptr, stroke).lay(none, {.position = {0, 0, 0}}).size(), 1u);
  EXPECT_TRUE(none.has("seeds"));
}

}  // namespace
}  // namespace stipple
