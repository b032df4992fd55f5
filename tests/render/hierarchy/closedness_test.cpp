#include "render/hierarchy/closedness.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/io/point_io.h"
#include "render/hierarchy/build.h"
#include "render/hierarchy/cut.h"
#include "render/hierarchy/splat_radii.h"
#include "tests/support/sampled_hierarchy.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

constexpr Index kCount = 30'000;

PointSet pointsOf(const scenes::SurfaceSamples& samples) {
  PointSet points(samples.positions);
  points.set("normal", samples.normals);
  return points;
}

/// Points, and discs from blocks of leaves as in the first picture.
bool isClosedByBlocks(const scenes::SurfaceSamples& samples) {
  return isClosedAndOriented(pointsOf(samples), buildHierarchy(leavesOf(samples), LeafOrder::kMorton));
}

bool isClosedByFans(const PointSet& points) {
  const SurfaceEstimate surface = estimateSurface(points);
  return isClosedAndOriented(points, buildHierarchy({.positions = points.positions(),
                                                     .radii = surface.radii,
                                                     .areas = surface.areas,
                                                     .normals = surface.normals,
                                                     .colors = {}},
                                                    LeafOrder::kKd));
}

/// Without the samples for which `leavesOut(position)`.
template <class Predicate>
scenes::SurfaceSamples without(const scenes::SurfaceSamples& samples, const Predicate& leavesOut) {
  scenes::SurfaceSamples kept;
  for (std::size_t i = 0; i < samples.positions.size(); ++i) {
    if (leavesOut(samples.positions[i])) continue;
    kept.positions.push_back(samples.positions[i]);
    kept.normals.push_back(samples.normals[i]);
    kept.colors.push_back(samples.colors[i]);
  }
  return kept;
}

TEST(Closedness, SeesThatSampledBodiesAreClosed) {
  for (const scenes::Scene& scene : {scenes::checkeredSphere(), scenes::rippledTorus()}) {
    const scenes::SurfaceSamples samples = scene.sample(kCount, 1);
    EXPECT_TRUE(isClosedByBlocks(samples)) << scene.name;
    EXPECT_TRUE(isClosedByFans(pointsOf(samples))) << scene.name;
  }
}

TEST(Closedness, SeesHoles) {
  const scenes::SurfaceSamples sphere = scenes::checkeredSphere().sample(kCount, 1);
  // A half, a cap, and a hole of ten spacings.
  for (const float height : {0.f, 0.8f, 0.994f}) {
    const auto open = without(sphere, [&](const Eigen::Vector3f& p) { return p.z() > height; });
    EXPECT_FALSE(isClosedByBlocks(open)) << height;
    EXPECT_FALSE(isClosedByFans(pointsOf(open))) << height;
  }
}

TEST(Closedness, SeesNormalsThatPointInwards) {
  scenes::SurfaceSamples inwards = scenes::checkeredSphere().sample(kCount, 1);
  scenes::SurfaceSamples patch = inwards;
  for (std::size_t i = 0; i < patch.normals.size(); ++i) {
    inwards.normals[i] *= -1;
    if (patch.positions[i].z() > 0.99f) patch.normals[i] *= -1;
  }
  EXPECT_FALSE(isClosedByBlocks(inwards));
  EXPECT_FALSE(isClosedByBlocks(patch));
  EXPECT_FALSE(isClosedByFans(pointsOf(patch)));
}

TEST(Closedness, SeesASheetBesideAClosedBody) {
  scenes::SurfaceSamples both = scenes::checkeredSphere().sample(kCount, 1);
  for (int i = 0; i < 400; ++i) {
    both.positions.emplace_back(1.2f + 0.02f * static_cast<float>(i % 20), 0,
                                0.02f * static_cast<float>(i / 20));
    both.normals.emplace_back(0, 1, 0);
    both.colors.push_back({});
  }
  EXPECT_FALSE(isClosedByBlocks(both));
}

TEST(Closedness, SaysNoToWhatIsNoSurface) {
  EXPECT_FALSE(isClosedByBlocks({}));
  EXPECT_FALSE(isClosedByBlocks({{{1, 2, 3}}, {{0, 0, 1}}, {{}}}));
  const std::vector<Eigen::Vector3f> one(100, {1, 2, 3}), up(100, {0, 0, 1});
  EXPECT_FALSE(isClosedByBlocks({one, up, std::vector<Rgba8>(100)}));
  // Dots far apart, and discs of very different sizes.
  const std::vector<Eigen::Vector3f> apart{{0, 0, 0}, {1, 0, 0}, {1, 1e-3f, 0}, {0, 1e-3f, 1e-3f}};
  for (const float radius : {1e-6f, 1.f}) {
    const std::vector<float> radii{radius, radius, 1e-6f, 1e-6f};
    const Hierarchy dots = buildHierarchy(
        {.positions = apart, .radii = radii, .areas = {}, .normals = std::span(up).first(4), .colors = {}},
        LeafOrder::kKd);
    EXPECT_FALSE(isClosedAndOriented(PointSet(apart), dots));
  }
}

TEST(Closedness, OfTrianglesAsksForBothSidesOfEveryEdge) {
  const std::vector<Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_TRUE(areClosed(tetrahedron, 4));
  EXPECT_FALSE(areClosed(tetrahedron, 5));  // a point of no triangle
  EXPECT_FALSE(areClosed(std::vector<Triangle>{}, 0));
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<Triangle> open = tetrahedron, turned = tetrahedron, twice = tetrahedron, flat = tetrahedron;
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
    std::swap(turned[i][0], turned[i][1]);
    twice.push_back(twice[i]);
    flat.push_back({0, 0, 1});
    EXPECT_FALSE(areClosed(open, 4));
    EXPECT_FALSE(areClosed(turned, 4));
    EXPECT_FALSE(areClosed(twice, 4));
    EXPECT_TRUE(areClosed(flat, 4));
  }
}

TEST(Closedness, KnowsInsideAndOutside) {
  const Hierarchy torus = sampledHierarchy(scenes::rippledTorus(), kCount);
  for (int i = 0; i < 12; ++i) {
    const float angle = 0.5236f * static_cast<float>(i);
    const glm::vec3 around(std::cos(angle), std::sin(angle), 0);
    EXPECT_TRUE(isInside(torus, around));
    EXPECT_TRUE(isInside(torus, 1.3f * around));
    EXPECT_FALSE(isInside(torus, 0.4f * around));
    EXPECT_FALSE(isInside(torus, 1.6f * around));
    EXPECT_FALSE(isInside(torus, around + glm::vec3(0, 0, 0.6f)));
  }
  EXPECT_FALSE(isInside(torus, {0, 0, 0}));
  EXPECT_FALSE(isInside(torus, {0, 0, 100}));
  EXPECT_FALSE(isInside({}, {0, 0, 0}));
}

TEST(Closedness, ShowsBacksToWhoLooksFromInside) {
  Hierarchy sphere = sampledHierarchy(scenes::checkeredSphere(), kCount);
  View view = frameView({{0, 0, 0}, 1}, {}, 400, 400);
  view.eye = {0.2f, 0.1f, 0};
  const std::vector<Index> all = selectCut(sphere, view, {}).nodes;
  sphere.isClosedAndOriented = true;
  EXPECT_EQ(selectCut(sphere, view, {}).nodes, all);
}

struct Scan {
  const char* path;
  bool isClosed;
};

TEST(Closedness, OfRealScans) {
  STIPPLE_NEEDS_TEST_DATA();
  constexpr Scan kScans[] = {
      {"smooth/igea_134k.ply", true},
      {"smooth/armadillo_43k.obj", true},
      {"smooth/bunny_adaptive.off", true},
      {"smooth/kitten.xyz", true},
      {"cc0/spot_oded/spot_11k.obj", true},
      {"cad/fandisk.off", true},
      {"smooth/bun_zipper_ascii.ply", false},
      {"smooth/bun_zipper_binary_le_points.ply", false},
      {"smooth/bunny70k_meshlab.ply", false},
      {"smooth/head_face_open.obj", false},
      {"cad/cube_50k.pwn", false},
      {"colour/ankylosaurus_mesh.ply", false},  // no points below, which triangles bridge
      {"colour/Laurana50k.ply", false},
      {"formats/oni.pwn", false},
      {"formats/ripple_cloudcompare_binary.ply", false},
      {"noisy/lato000_rangemap.ply", false},
      {"noisy/lidar_street_source.ply", false},
      {"noisy/sphere_20k_noise_outliers.xyz", false},
      {"open/lion-head.off", false},
      {"open/camelhead_crlf.off", false},
      {"open/lionstatue_31k.obj", false},
      {"open/hemisphere.off", false}};
  for (const auto& [path, isClosed] : kScans) {
    Progress progress;
    PointSet points = readPoints(testData(path), progress).points;
    EXPECT_EQ(isClosedByFans(points), isClosed) << path;
    if (isClosed) continue;
    // Nor by its points and their normals alone, with discs from blocks.
    const std::vector<Eigen::Vector3f> normals = normalsOfFile(points);
    points.setTriangles({});
    EXPECT_FALSE(isClosedAndOriented(
        points,
        buildHierarchy(
            {.positions = points.positions(), .radii = {}, .areas = {}, .normals = normals, .colors = {}},
            LeafOrder::kMorton)))
        << path;
  }
}

}  // namespace
}  // namespace stipple
