#include "tests/support/popping.h"

#include <gtest/gtest.h>

#include "render/splat/cpu_renderer.h"
#include "tests/support/sampled_hierarchy.h"

namespace stipple {
namespace {

TEST(Popping, StaysBelowTheMotionOfAZoom) {
  const scenes::Scene sphere = scenes::checkeredSphere();
  const Hierarchy hierarchy = sampledHierarchy(sphere, 300'000);
  CpuRenderer renderer;
  const ZoomPath path{.start = {.yaw = 0.3f, .pitch = 0.67f}, .lastZoom = 1.5f, .width = 200, .height = 120};
  const Popping popping = measurePopping(renderer, hierarchy, sphere.surface, path, {.tau = 6});
  EXPECT_EQ(popping.incompleteFrames, 0);
  EXPECT_EQ(popping.holes, 0);
  // Of 255: no frame changes by more than half a step beyond what the surface does, no square of 16 x 16 by
  // five.
  EXPECT_LT(popping.worst, 0.5);
  EXPECT_LT(popping.worstTile, 5);
}

}  // namespace
}  // namespace stipple
