#include "app/view/frame_maker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "render/hierarchy/view.h"
#include "tests/app/view/shown_points.h"

namespace stipple {
namespace {

View viewAt(float yaw) {
  return frameView({{0, 0, 0}, 1}, {.yaw = yaw}, 160, 120);
}

NewSurface surfaceOf(const PointSet& points, std::uint64_t number = 1) {
  return {.surface = number, .points = points, .colors = PointColors(points, {})};
}

// Works until nothing is due any more.
int settle(FrameMaker& maker) {
  int pictures = 0;
  while (const auto due = maker.nextDue()) {
    std::this_thread::sleep_until(*due);
    pictures += maker.step(nullptr);
  }
  return pictures;
}

std::size_t covered(const Frame& frame) {
  return static_cast<std::size_t>(
      std::ranges::count_if(frame.depth, [](float d) { return std::isfinite(d); }));
}

class MakingFrames : public testing::Test {
 protected:
  PointSet points = shownSphere(20000);
  FrameMaker maker{makeRenderer(Backend::kCpu)};
};

TEST_F(MakingFrames, NothingIsDueWithoutPointsOrView) {
  EXPECT_FALSE(maker.nextDue());
  EXPECT_FALSE(maker.step(nullptr));
  maker.setView(viewAt(0));
  EXPECT_FALSE(maker.step(nullptr));
  maker.apply(surfaceOf(PointSet()), 1, nullptr);
  EXPECT_FALSE(maker.step(nullptr));
}

TEST_F(MakingFrames, ShowsASphereOfTheRightSizeAtOnceAndRefinesIt) {
  maker.apply(surfaceOf(points), 5, nullptr);
  maker.setView(viewAt(0));
  ASSERT_TRUE(maker.step(nullptr));
  const Frame first = maker.frame();
  EXPECT_EQ(first.revision, 5u);
  // The sphere fills the height of the picture.
  EXPECT_NEAR(static_cast<double>(covered(first)), 3.14159 * 60 * 60, 400);
  settle(maker);
  const Frame last = maker.frame();
  EXPECT_TRUE(last.isConverged);
  EXPECT_EQ(last.averaged, 16);
  EXPECT_FALSE(maker.nextDue()) << "a picture at rest costs nothing";
}

TEST_F(MakingFrames, AnInterruptedRefinementLeavesThePicture) {
  class Now final : public Progress {
    bool cancelled() const override { return true; }
  } now;
  maker.apply(surfaceOf(points), 1, nullptr);
  maker.setView(viewAt(0));
  ASSERT_TRUE(maker.step(&now)) << "what shows a change is not interrupted";
  const Image before = maker.frame().image;
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_FALSE(maker.step(&now));
  EXPECT_EQ(maker.frame().image.pixels, before.pixels);
}

TEST_F(MakingFrames, PaintedRowsShowAsIfTheyHadAlwaysBeenSo) {
  maker.apply(surfaceOf(points), 1, nullptr);
  maker.setView(viewAt(0));
  settle(maker);
  Recolor change;
  for (Index row = 0; row < points.size(); row += 7) {
    points.edit<Rgba8>("color")[row] = {250, 20, 20, 255};
    change.rows.push_back(row);
    change.colors.push_back({250, 20, 20, 0});
  }
  maker.apply(change, 2, nullptr);
  EXPECT_TRUE(maker.step(nullptr));
  EXPECT_EQ(maker.frame().revision, 2u);
  settle(maker);
  FrameMaker fresh(makeRenderer(Backend::kCpu));
  fresh.apply(surfaceOf(points), 1, nullptr);
  fresh.setView(viewAt(0));
  settle(fresh);
  EXPECT_EQ(maker.frame().image.pixels, fresh.frame().image.pixels);
}

TEST_F(MakingFrames, ABetterHierarchyKeepsTheColorsOfNow) {
  maker.apply(surfaceOf(points), 1, nullptr);
  maker.setView(viewAt(0));
  settle(maker);
  auto waiting = maker.takeUnrefined();
  ASSERT_TRUE(waiting);
  EXPECT_FALSE(maker.takeUnrefined()) << "once a surface";
  Hierarchy refined = refineHierarchy(waiting->points, waiting->colors.of(waiting->points), nullptr);
  Recolor change{.rows = {3}, .colors = {{1, 2, 3, 0}}};
  maker.apply(change, 2, nullptr);
  maker.apply(Refined{.surface = 1, .hierarchy = std::move(refined)}, 0, nullptr);
  const Hierarchy& shown = maker.surface().hierarchy();
  for (Index point = 0; point < points.size(); ++point) {
    Rgba8 expected = points.values<Rgba8>("color")[point];
    if (point == 3) expected = {1, 2, 3, 0};
    expected.a = 0;
    ASSERT_EQ(shown.splats()[shown.slotOfPoint[point]].color, expected) << point;
  }
}

TEST_F(MakingFrames, ASurfaceTooLargeForASecondHierarchyIsBetteredInPlace) {
  maker.refinementBudget = 0;
  maker.apply(surfaceOf(points), 1, nullptr);
  maker.setView(viewAt(0));
  settle(maker);
  EXPECT_FALSE(maker.takeUnrefined());
  const Hierarchy& shown = maker.surface().hierarchy();
  EXPECT_TRUE(shown.isClosedAndOriented);
  EXPECT_TRUE(maker.frame().isConverged);
  const Rgba8 painted{250, 20, 20, 0};
  maker.apply(Recolor{.rows = {3}, .colors = {painted}}, 2, nullptr);
  EXPECT_EQ(shown.splats()[shown.slotOfPoint[3]].color, painted);
  settle(maker);
  // Moved points are asked anew.
  maker.apply(Restate{.surface = 2, .points = points, .colors = PointColors(points, {}), .moved = true}, 3,
              nullptr);
  EXPECT_FALSE(shown.isClosedAndOriented);
  settle(maker);
  EXPECT_TRUE(shown.isClosedAndOriented);
}

TEST_F(MakingFrames, AHierarchyOfAnotherSurfaceIsDropped) {
  maker.apply(surfaceOf(points, 1), 1, nullptr);
  Hierarchy refined = refineHierarchy(points, {}, nullptr);
  const PointSet others = shownSphere(points.size(), 9);
  maker.apply(surfaceOf(others, 2), 2, nullptr);
  const Splat before = maker.surface().hierarchy().splats()[0];
  maker.apply(Refined{.surface = 1, .hierarchy = std::move(refined)}, 0, nullptr);
  EXPECT_EQ(maker.surface().hierarchy().splats()[0].center(), before.center());
}

TEST_F(MakingFrames, TrianglesAreShownWhereAskedFor) {
  PointSet triangle({{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}});
  triangle.setTriangles({{0, 1, 2}});
  maker.apply(
      NewSurface{.surface = 1, .points = triangle, .colors = PointColors(triangle, {}), .asMesh = true}, 1,
      nullptr);
  maker.setView(viewAt(0));
  ASSERT_TRUE(maker.step(nullptr));
  // Half of the square of 2 x 2 about a sphere of radius 1 that fills 120 pixels.
  const double perUnit = 60 * std::cos(kFieldOfView / 2);
  EXPECT_NEAR(static_cast<double>(covered(maker.frame())), 2 * perUnit * perUnit, 300);
}

}  // namespace
}  // namespace stipple
