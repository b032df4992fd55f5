#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/fans.h"
#include "core/points/point_set.h"

namespace stipple {

struct TriangulationOptions {
  bool votes = true;     ///< false: only triangles that all three fans share
  int longestHole = 12;  ///< edges of the boundary loops that are closed; 0: none
};

/// A conforming set of triangles from fans that were built each by itself (Section 9 of the paper, with
/// votes): triangles of all three fans stand, disputed ones are taken patch by patch as in consensus.h, small
/// holes are closed. Corners are sites; no edge has more than two triangles. Winding as in windAlong().
/// `normals`: m x 3, unit, of one sense.
std::vector<Triangle> triangulateFans(std::span<const Eigen::Vector3f> positions,
                                      std::span<const Eigen::Vector3f> normals, const Fans& fans,
                                      const TriangulationOptions& options,
                                      const Progress* progress = nullptr);

/// Turns triangles so that neighbors run opposite ways along their common edge, each connected part
/// counterclockwise about most of its normals. On a surface with one side some edges stay inconsistent.
void windAlong(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
               std::span<Triangle> triangles);

}  // namespace stipple
