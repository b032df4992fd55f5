#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/progress.h"
#include "render/appearance/surface_mesh.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// What is seen of triangles, by pixel, rows from the top.
struct MeshLayer {
  static constexpr Index kNone = static_cast<Index>(-1);

  std::vector<float> depth;        ///< infinite where there is nothing
  std::vector<Index> triangles;    ///< kNone where there is nothing
  std::vector<glm::vec3> normals;  ///< view space, unit; 0 where there is nothing
  std::vector<glm::vec3> colors;   ///< linear
  std::vector<float> selected;     ///< how much, 0 to 1
};

/// The nearest triangle under the center of each pixel, seen from either side; of equally near ones the
/// first. What is nearer than the view's near depth is cut off. Pixels whose center lies on an edge belong to
/// the triangle on the right of it or below, so that triangles that meet leave no gap and count no pixel
/// twice. Inside of a triangle depth, normal and color vary as on the surface. Normals may be empty, and
/// where they cancel out those of the triangle's plane are taken; without colors triangles are light gray.
/// Triangles of no area or with corners that are not finite are not seen. Same bits for any number of
/// threads. Throws Cancelled.
void rasterizeTriangles(const SurfaceMesh& mesh, const View& view, MeshLayer& out,
                        const Progress* progress = nullptr);

}  // namespace stipple
