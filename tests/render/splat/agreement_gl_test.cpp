#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/io/point_io.h"
#include "render/hierarchy/splat_radii.h"
#include "render/splat/cpu_renderer.h"
#include "render/splat/gl_renderer.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/picture_difference.h"
#include "tests/support/splat_scenes.h"
#include "tests/support/test_data.h"

// Both back ends draw the same picture: mean difference of a channel below 1/255, 99.9 % of pixels within
// 8/255.

namespace stipple {
namespace {

using AgreementTest = GlTest;

// What both draw of one cut; remembers hierarchy and renderers.
class Pair {
 public:
  explicit Pair(Hierarchy hierarchy) : hierarchy_(std::move(hierarchy)) {
    upload(scenes::allNodes(hierarchy_));
  }

  void draw(const std::string& what, const View& view, const Appearance& appearance,
            Accumulate accumulate = Accumulate::kStartAnew) {
    const Cut cut = selectCut(hierarchy_, view, {});
    for (Renderer* renderer : renderers())
      renderer->draw(hierarchy_, cut.nodes, view, appearance, accumulate);
    compare(what, view);
  }

  // As a dab does it.
  void paint(const std::vector<Index>& slots, const Rgba8& color, const View& view) {
    for (const Index slot : slots) hierarchy_.editSplats()[slot].color = color;
    const std::vector<NodeRange> changed = refit(hierarchy_, slots);
    upload(changed);
    for (Renderer* renderer : renderers()) renderer->redraw(hierarchy_, changed);
    compare("painted", view);
  }

  Image image() { return gl_.image(); }

 private:
  std::array<Renderer*, 2> renderers() { return {&gl_, &cpu_}; }
  void upload(const std::vector<NodeRange>& changed) {
    for (Renderer* renderer : renderers()) renderer->upload(hierarchy_, changed);
  }

  // Pictures, and what is picked on a coarse grid.
  void compare(const std::string& what, const View& view) {
    expectSamePicture(what, gl_.image(), cpu_.image());
    int same = 0, all = 0, covered = 0;
    for (int y = 0; y < view.height; y += 5) {
      for (int x = 0; x < view.width; x += 5) {
        const std::optional<Pick> a = gl_.pick(x, y), b = cpu_.pick(x, y);
        bool isSame = a.has_value() == b.has_value();
        if (a && b) {
          const float radius = hierarchy_.splats()[a->node].radius;
          isSame = a->node == b->node && std::abs(a->depth - b->depth) <= 0.05f * radius;
        }
        same += isSame;
        covered += a.has_value();
        ++all;
      }
    }
    EXPECT_GE(same, 0.99 * all) << what;
    EXPECT_GT(covered, 0) << what;
  }

  Hierarchy hierarchy_;
  GlRenderer gl_;
  CpuRenderer cpu_;
};

Appearance withMode(SplatMode mode) {
  Appearance appearance;
  appearance.mode = mode;
  return appearance;
}

// Far, near and through the surface, in both projections and all modes.
void compareViews(Pair& pair, const FramingSphere& sphere, UpAxis up) {
  const std::array<const char*, 3> modes = {"splats", "discs", "points"};
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    for (const float zoom : {0.3f, 1.f, 6.f}) {
      const CameraAngles angles = {
          .yaw = 0.5f, .pitch = 0.35f, .zoom = zoom, .up = up, .projection = projection};
      const View view = frameView(sphere, angles, 320, 240);
      for (const SplatMode mode : {SplatMode::kSplats, SplatMode::kDiscs, SplatMode::kPoints}) {
        const std::string what = std::string(view.isPerspective() ? "perspective" : "orthographic") +
                                 ", zoom " + std::to_string(zoom).substr(0, 3) + ", " +
                                 modes[static_cast<int>(mode)];
        pair.draw(what, view, withMode(mode));
      }
    }
  }
}

TEST_F(AgreementTest, Sphere) {
  Pair pair(scenes::hierarchyOf(scenes::sphere(40'000)));
  compareViews(pair, {}, UpAxis::kZ);
}

TEST_F(AgreementTest, Torus) {
  Pair pair(scenes::hierarchyOf(scenes::torus(40'000)));
  compareViews(pair, {.radius = 1.4f}, UpAxis::kZ);
}

TEST_F(AgreementTest, APlaneSeenEdgeOn) {
  Pair pair(scenes::hierarchyOf(scenes::square(20'000)));
  for (const float pitch : {0.f, 0.01f, 0.05f, 0.2f}) {
    for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
      const CameraAngles angles = {.yaw = 0.3f, .pitch = pitch, .zoom = 1.5f, .projection = projection};
      pair.draw("edge-on, pitch " + std::to_string(pitch), frameView({}, angles, 320, 240),
                withMode(SplatMode::kSplats));
    }
  }
}

TEST_F(AgreementTest, WhatAppearanceOffers) {
  scenes::Surface torus = scenes::torus(20'000);
  for (std::size_t i = 0; i < torus.colors.size(); ++i) {
    torus.colors[i].a = torus.positions[i].x() > 0.3f ? 255 : 0;
  }
  Pair pair(scenes::hierarchyOf(torus));
  View view = frameView({.radius = 1.4f}, {.pitch = 0.7f}, 300, 200);
  Appearance appearance;
  pair.draw("selection", view, appearance);
  appearance.background.reset();
  pair.draw("transparent", view, appearance);
  appearance.background = Rgba8{240, 240, 235, 255};
  appearance.brush = BrushRing{.center = {0, -1.2f, 0.3f}, .radius = 0.3f, .color = {40, 220, 90, 255}};
  pair.draw("brush", view, appearance);
  appearance.lit = false;
  appearance.edgeStrength = 0;
  pair.draw("unlit", view, appearance);
  appearance.lit = true;
  appearance.twoSided = false;
  view.jitterPx = {0.3f, -0.4f};
  pair.draw("one side, shifted", view, appearance);
}

TEST_F(AgreementTest, MeanOfShiftedFrames) {
  Pair pair(scenes::hierarchyOf(scenes::torus(20'000)));
  View view = frameView({.radius = 1.4f}, {.pitch = 0.7f}, 200, 150);
  Appearance appearance;
  appearance.isOneOfMany = true;
  for (int frame = 0; frame < 5; ++frame) {
    view.jitterPx = {0.2f * static_cast<float>(frame) - 0.4f, 0.3f - 0.15f * static_cast<float>(frame)};
    pair.draw("frame " + std::to_string(frame), view, appearance,
              frame == 0 ? Accumulate::kStartAnew : Accumulate::kAddToMean);
  }
}

TEST_F(AgreementTest, PaintedAndDrawnAgain) {
  const scenes::Surface torus = scenes::torus(20'000);
  Hierarchy hierarchy = scenes::hierarchyOf(torus);
  std::vector<Index> slots;
  for (Index slot = 0; slot < hierarchy.leafCount(); ++slot) {
    if (glm::distance(hierarchy.splats()[slot].center(), glm::vec3(0, -1.2f, 0.3f)) < 0.3f)
      slots.push_back(slot);
  }
  Pair pair(std::move(hierarchy));
  const View view = frameView({.radius = 1.4f}, {.pitch = 0.7f}, 300, 200);
  pair.draw("before", view, {});
  const Image before = pair.image();
  pair.paint(slots, {20, 230, 60, 0}, view);
  EXPECT_GT(differenceOf(before, pair.image()).mean, 0.2);
}

TEST_F(AgreementTest, InsideTheSurfaceCloseToTheEye) {
  Pair pair(scenes::hierarchyOf(scenes::sphere(3'000)));
  View view = frameView({}, {.zoom = 1}, 320, 240);
  view.eye = {0.2f, -0.9f, 0.1f};  // a tenth from the wall, inside
  view.nearDepth = 1e-3f;
  for (const SplatMode mode : {SplatMode::kSplats, SplatMode::kDiscs}) {
    pair.draw("inside", view, withMode(mode));
    view.viewFromWorld[1] = -view.viewFromWorld[1];
    view.viewFromWorld[0] = -view.viewFromWorld[0];
    pair.draw("inside, towards the wall", view, withMode(mode));
  }
}

void compareScan(const std::string& file, UpAxis up) {
  Progress progress;
  const PointSet points = readPoints(testData(file), progress).points;
  const SurfaceEstimate estimate = estimateSurface(points);
  std::vector<Rgba8> colors;
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : points.positions()) box.extend(p);
  for (const Eigen::Vector3f& p : points.positions())
    colors.push_back(scenes::checker(p, box.diagonal().norm() / 16));
  Pair pair(buildHierarchy({.positions = points.positions(),
                            .radii = estimate.radii,
                            .areas = estimate.areas,
                            .normals = estimate.normals,
                            .colors = colors},
                           LeafOrder::kKd));
  const Eigen::Vector3f center = box.center();
  compareViews(pair, {.center = {center.x(), center.y(), center.z()}, .radius = box.diagonal().norm() / 2},
               up);
}

TEST_F(AgreementTest, ScanWithoutNormals) {
  STIPPLE_NEEDS_TEST_DATA();
  compareScan("smooth/bun_zipper_binary_le_points.ply", UpAxis::kY);
}

TEST_F(AgreementTest, NoisyScan) {
  STIPPLE_NEEDS_TEST_DATA();
  compareScan("noisy/lato000_rangemap.ply", UpAxis::kZ);
}

}  // namespace
}  // namespace stipple
