#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/io/point_io.h"
#include "render/hierarchy/splat_radii.h"
#include "render/splat/cpu_renderer.h"
#include "render/splat/gl_renderer.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/splat_scenes.h"
#include "tests/support/test_data.h"

// Both back ends draw the same picture: mean difference of a channel below 1/255, 99.9 % of pixels within
// 8/255.

namespace stipple {
namespace {

using AgreementTest = GlTest;

struct Difference {
  double mean = 0;    // of a channel, of 255
  double within = 1;  // share of the pixels whose channels all differ by at most 8
  double nodes = 1;   // share of the pixels that name the same node
  int covered = 0;    // pixels of a coarse grid that name one
};

Difference compare(const Image& a, const Image& b) {
  double sum = 0;
  std::size_t within = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgba8 &p = a.pixels[i], &q = b.pixels[i];
    const std::array<int, 4> off = {std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b),
                                    std::abs(p.a - q.a)};
    sum += off[0] + off[1] + off[2] + off[3];
    within += *std::ranges::max_element(off) <= 8;
  }
  const auto pixels = static_cast<double>(a.pixels.size());
  return {.mean = sum / 4 / pixels, .within = static_cast<double>(within) / pixels};
}

// What both draw of one cut; remembers hierarchy and renderers.
class Pair {
 public:
  explicit Pair(Hierarchy hierarchy) : hierarchy_(std::move(hierarchy)) {
    gl_.upload(hierarchy_, scenes::allNodes(hierarchy_));
    cpu_.upload(hierarchy_, scenes::allNodes(hierarchy_));
  }

  Difference draw(const View& view, const Appearance& appearance, float tau = 3) {
    const Cut cut = selectCut(hierarchy_, view, {.tau = tau});
    gl_.draw(hierarchy_, cut.nodes, view, appearance, Accumulate::kStartAnew, nullptr);
    cpu_.draw(hierarchy_, cut.nodes, view, appearance, Accumulate::kStartAnew, nullptr);
    Difference difference = compare(gl_.image(), cpu_.image());
    int same = 0, all = 0;
    for (int y = 0; y < view.height; y += 5) {
      for (int x = 0; x < view.width; x += 5) {
        const std::optional<Pick> a = gl_.pick(x, y), b = cpu_.pick(x, y);
        same += a && b ? a->node == b->node : a.has_value() == b.has_value();
        difference.covered += a.has_value();
        ++all;
      }
    }
    difference.nodes = static_cast<double>(same) / all;
    return difference;
  }

 private:
  Hierarchy hierarchy_;
  GlRenderer gl_;
  CpuRenderer cpu_;
};

void expectAgreement(const std::string& what, const Difference& difference) {
  EXPECT_LT(difference.mean, 1) << what;
  EXPECT_GE(difference.within, 0.999) << what;
  EXPECT_GE(difference.nodes, 0.99) << what;
  EXPECT_GT(difference.covered, 0) << what;
}

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
        expectAgreement(what, pair.draw(view, withMode(mode)));
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
      expectAgreement("edge-on, pitch " + std::to_string(pitch),
                      pair.draw(frameView({}, angles, 320, 240), withMode(SplatMode::kSplats)));
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
  expectAgreement("selection", pair.draw(view, appearance));
  appearance.background.reset();
  expectAgreement("transparent", pair.draw(view, appearance));
  appearance.background = Rgba8{240, 240, 235, 255};
  appearance.brush = BrushRing{.center = {0, -1.2f, 0.3f}, .radius = 0.3f, .color = {40, 220, 90, 255}};
  expectAgreement("brush", pair.draw(view, appearance));
  appearance.lit = false;
  appearance.edgeStrength = 0;
  expectAgreement("unlit", pair.draw(view, appearance));
  appearance.lit = true;
  appearance.twoSided = false;
  view.jitterPx = {0.3f, -0.4f};
  expectAgreement("one side, shifted", pair.draw(view, appearance));
}

TEST_F(AgreementTest, InsideTheSurfaceCloseToTheEye) {
  Pair pair(scenes::hierarchyOf(scenes::sphere(3'000)));
  View view = frameView({}, {.zoom = 1}, 320, 240);
  view.eye = {0.2f, -0.9f, 0.1f};  // a tenth from the wall, inside
  view.nearDepth = 1e-3f;
  for (const SplatMode mode : {SplatMode::kSplats, SplatMode::kDiscs}) {
    expectAgreement("inside", pair.draw(view, withMode(mode)));
    view.viewFromWorld[1] = -view.viewFromWorld[1];
    view.viewFromWorld[0] = -view.viewFromWorld[0];
    expectAgreement("inside, towards the wall", pair.draw(view, withMode(mode)));
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
