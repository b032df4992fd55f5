#include "app/cli/scene.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/files.h"
#include "render/hierarchy/build.h"
#include "render/hierarchy/closedness.h"
#include "render/hierarchy/splat_radii.h"

namespace stipple {

namespace {

// Where the points lack what the user names, that is wrong use, not a broken file.
template <class Call>
auto asUsage(const RenderOptions& options, Call&& call) {
  try {
    return call();
  } catch (const InvalidInput& error) {
    throw CommandFailure(kUsage, fmt::format("{}: {}", options.input, error.what()));
  }
}

// Of a single place the sphere is as large as shows its disc at a tenth of the height.
FramingSphere frame(const PointSet& points, std::span<const float> radii) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : points.positions()) box.extend(p);
  const Eigen::Vector3f center = box.center();
  float radius = 0;
  for (const Eigen::Vector3f& p : points.positions()) radius = std::max(radius, (p - center).norm());
  if (!(radius > 0)) radius = radii.empty() ? 1 : 10 * *std::ranges::max_element(radii);
  return {{center.x(), center.y(), center.z()}, radius};
}

void prepareTriangles(const RenderOptions& options, Scene& scene) {
  if (scene.points.triangles().empty()) {
    throw CommandFailure(
        kUsage, fmt::format("{}: holds no triangles, which --surface mesh would draw", options.input));
  }
  scene.meshNormals = normalsOfFile(scene.points);
  scene.sphere = frame(scene.points, {});
}

void prepareSplats(const RenderOptions& options, Scene& scene, StageSeconds& seconds, Progress& progress) {
  // Pixels have no radius of their own.
  const bool needsRadii = options.appearance.mode != SplatMode::kPoints;
  const SurfaceEstimate surface = seconds.measure("surface", [&] {
    return needsRadii ? estimateSurface(scene.points, &progress)
                      : SurfaceEstimate{.radii = {}, .areas = {}, .normals = normalsOfFile(scene.points)};
  });
  progress.report(0.8, "building the hierarchy");
  scene.hierarchy = seconds.measure("hierarchy", [&] {
    return buildHierarchy({.positions = scene.points.positions(),
                           .radii = surface.radii,
                           .areas = surface.areas,
                           .normals = surface.normals,
                           .colors = scene.colors},
                          LeafOrder::kKd, &progress);
  });
  seconds.measure("closedness", [&] {
    scene.hierarchy.isClosedAndOriented = isClosedAndOriented(scene.points, scene.hierarchy, &progress);
  });
  scene.sphere = frame(scene.points, surface.radii);
}

}  // namespace

Scene readScene(const RenderOptions& options, StageSeconds& seconds, Progress& progress) {
  PartialProgress reading(progress, 0, 0.4), preparing(progress, 0.4, 1);
  ReadResult read = seconds.measure("read", [&] { return readInput(options.input, reading); });
  Scene scene;
  scene.points = std::move(read.points);
  scene.warnings = std::move(read.warnings);

  preparing.report(0, "coloring");
  seconds.measure("colors", [&] {
    asUsage(options, [&] {
      scene.colors = colorPoints(scene.points, options.colors);
      if (!options.glyphs.empty()) scene.glyphs = makeGlyphs(scene.points, options.glyphs, {}, &progress);
    });
  });
  if (options.drawsTriangles) {
    seconds.measure("surface", [&] { prepareTriangles(options, scene); });
  } else {
    preparing.report(0.1, "estimating the surface");
    prepareSplats(options, scene, seconds, preparing);
  }
  return scene;
}

}  // namespace stipple
