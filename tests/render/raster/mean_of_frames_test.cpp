#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/hierarchy/jitter.h"
#include "render/splat/cpu_renderer.h"
#include "tests/support/splat_scenes.h"

// Contours of a mean of shifted frames lie where those of the surface do.

namespace stipple {
namespace {

constexpr int kFrames = 16;

// Pixels that are covered, each by its share.
double coveredArea(const Hierarchy& hierarchy, View view, float tau) {
  CpuRenderer renderer;
  Appearance appearance;
  appearance.background = std::nullopt;
  appearance.isOneOfMany = true;
  for (int frame = 0; frame < kFrames; ++frame) {
    view.jitterPx = jitterOfFrame(frame);
    const Cut cut = selectCut(hierarchy, view, {.tau = tau});
    renderer.draw(hierarchy, cut.nodes, view, appearance,
                  frame == 0 ? Accumulate::kStartAnew : Accumulate::kAddToMean, nullptr);
  }
  double sum = 0;
  for (const Rgba8& pixel : renderer.image().pixels) sum += pixel.a / 255.;
  return sum;
}

TEST(MeanOfFrames, ASphereHasTheAreaOfItsOutline) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(400'000));
  for (const float zoom : {0.25f, 0.5f, 1.f}) {
    const View view = frameView({}, {.zoom = zoom, .projection = Projection::kOrthographic}, 300, 300);
    const double radius = view.focalPx, area = std::numbers::pi * radius * radius;
    // Within .4 pixels all around; a kernel that reaches every pixel center is farther out than .5.
    EXPECT_NEAR(coveredArea(hierarchy, view, 2), area, 0.4 * 2 * std::numbers::pi * radius) << zoom;
  }
}

// A point far from others is seen at any distance: its dot has about a pixel's area.
TEST(MeanOfFrames, ASinglePointDoesNotFade) {
  scenes::Surface surface;
  for (const float x : {-0.5f, 0.5f}) {
    surface.positions.emplace_back(x, 0, 0);
    surface.normals.emplace_back(0, 0, 1);
    surface.radii.push_back(1e-4f);
    surface.colors.push_back({200, 200, 200, 0});
  }
  const Hierarchy hierarchy = scenes::hierarchyOf(surface);
  const View view = frameView({}, {.pitch = 1.2f}, 200, 200);
  EXPECT_NEAR(coveredArea(hierarchy, view, 2), 2, 0.5);
}

}  // namespace
}  // namespace stipple
