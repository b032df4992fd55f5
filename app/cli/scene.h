#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/cli/render_options.h"
#include "app/cli/stage_seconds.h"
#include "core/points/point_set.h"
#include "core/progress.h"
#include "render/appearance/surface_mesh.h"
#include "render/hierarchy/hierarchy.h"
#include "render/raster/glyphs.h"

namespace stipple {

/// All that pictures of a file are made from, whatever the camera.
struct Scene {
  PointSet points;
  FramingSphere sphere;
  std::vector<Rgba8> colors;                 ///< by point
  Hierarchy hierarchy;                       ///< empty where triangles are drawn
  std::vector<Eigen::Vector3f> meshNormals;  ///< by point, where triangles are drawn
  std::vector<Glyph> glyphs;
  std::vector<std::string> warnings;

  SurfaceMesh mesh() const { return {points.positions(), meshNormals, colors, points.triangles()}; }
};

/// Reads the file and prepares it. Ends the command with kFile where the file cannot be used, with kUsage
/// where it lacks what the options ask for.
Scene readScene(const RenderOptions& options, StageSeconds& seconds, Progress& progress);

}  // namespace stipple
