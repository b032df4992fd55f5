#include "app/view/frame_requests.h"

#include <gtest/gtest.h>

#include "tests/app/view/shown_points.h"

namespace stipple {
namespace {

TEST(FrameRequests, ANewSurfaceMakesAllEarlierChangesPointless) {
  const PointSet points = shownSphere(500);
  FrameRequests requests;
  requests.post(Recolor{.rows = {100000}, .colors = {{}}}, 1);  // would be out of range if it were applied
  requests.post(NewSurface{.surface = 3, .points = points, .colors = PointColors(points, {})}, 2);
  EXPECT_TRUE(requests.hasNewSurface());
  FrameMaker maker(makeRenderer(Backend::kCpu));
  requests.applyTo(maker, nullptr);
  EXPECT_EQ(maker.surfaceNumber(), 3u);
  EXPECT_FALSE(requests.hasAny());
}

TEST(FrameRequests, AStateThatReplacesAMovedOneStillMoves) {
  PointSet points = shownSphere(500);
  FrameRequests requests;
  FrameMaker maker(makeRenderer(Backend::kCpu));
  requests.post(NewSurface{.surface = 1, .points = points, .colors = PointColors(points, {})}, 1);
  requests.applyTo(maker, nullptr);
  for (Eigen::Vector3f& p : points.editPositions()) p *= 2;
  requests.post(Restate{.surface = 2, .points = points, .colors = PointColors(points, {}), .moved = true}, 2);
  requests.post(Restate{.surface = 2, .points = points, .colors = PointColors(points, {}), .moved = false},
                3);
  requests.applyTo(maker, nullptr);
  const Hierarchy& shown = maker.surface().hierarchy();
  for (Index point = 0; point < points.size(); ++point)
    ASSERT_NEAR(glm::length(shown.splats()[shown.slotOfPoint[point]].center()), 2, 1e-5);
}

}  // namespace
}  // namespace stipple
