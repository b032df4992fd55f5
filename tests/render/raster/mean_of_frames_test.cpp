#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/hierarchy/hidden_nodes.h"
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

// Even points, without a hole in any frame: along a spiral, turned by the golden angle from one to the next.
scenes::Surface spiralSphere(int count) {
  scenes::Surface surface;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.) / count, turn = std::numbers::pi * (3 - std::sqrt(5.)) * i;
    const double ring = std::sqrt(1 - z * z);
    surface.positions.emplace_back(ring * std::cos(turn), ring * std::sin(turn), z);
  }
  surface.normals = surface.positions;
  scenes::finish(surface, 4 * std::numbers::pi_v<float>);
  return surface;
}

// What is left out of the frames after the first was hidden there: they are the same to the bit.
TEST(MeanOfFrames, HiddenNodesDoNotChangeAPixel) {
  const Hierarchy hierarchy = scenes::hierarchyOf(spiralSphere(400'000));
  for (const float zoom : {0.3f, 1.f, 3.f}) {
    View view = frameView({}, {.pitch = 0.4f, .zoom = zoom}, 400, 300);
    view.jitterPx = jitterOfFrame(0);
    Appearance appearance;
    appearance.isOneOfMany = true;
    CpuRenderer all, some;
    const Cut cut = selectCut(hierarchy, view, {.tau = 2});
    all.draw(hierarchy, cut.nodes, view, appearance, Accumulate::kStartAnew, nullptr);
    const std::vector<Index> seen = withoutHidden(hierarchy, cut.nodes, view, all.depth());
    // The back, half of the sphere, but for a rim.
    const double share = static_cast<double>(seen.size()) / static_cast<double>(cut.nodes.size());
    EXPECT_LE(share, zoom == 1 ? 0.65 : 1) << zoom;
    for (int frame = 0; frame < kFrames; ++frame) {
      view.jitterPx = jitterOfFrame(frame);
      all.draw(hierarchy, cut.nodes, view, appearance, Accumulate::kStartAnew, nullptr);
      some.draw(hierarchy, seen, view, appearance, Accumulate::kStartAnew, nullptr);
      ASSERT_EQ(all.depth(), some.depth()) << zoom << " " << frame;
      ASSERT_TRUE(all.image().pixels == some.image().pixels) << zoom << " " << frame;
    }
  }
}

}  // namespace
}  // namespace stipple
