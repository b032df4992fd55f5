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
/// holes are closed. Corners are sites; no edge has more than two triangles; winding arbitrary. `normals`: m
/// x 3, unit, sign arbitrary.
std::vector<Triangle> triangulateFans(std::span<const Eigen::Vector3f> positions,
                                      std::span<const Eigen::Vector3f> normals, const Fans& fans,
                                      const TriangulationOptions& options,
                                      const Progress* progress = nullptr);

/// Turns triangles so that neighbors run opposite ways along their common edge, each connected part
/// counterclockwise about most of the normals `along` (m x 3, any length, may be empty); a part where they
/// are missing or say nothing faces up at its top. On a surface with one side some edges stay inconsistent.
void windTriangles(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> along,
                   std::span<Triangle> triangles);

}  // namespace stipple
