#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/points/point_set.h"
#include "tests/support/ray_scenes.h"

namespace stipple::scenes {

/// What rays meet first on the triangles of a point set, by a tree of boxes. Normals and colors are
/// interpolated from the corners: `normals` by point (empty: those of the faces), attribute `color` (absent:
/// light gray).
RaySurface castMesh(const PointSet& mesh, std::span<const Eigen::Vector3f> normals = {});

/// Area-weighted means of the normals of the faces about each point, unit; 0 where there is none.
std::vector<Eigen::Vector3f> cornerNormals(const PointSet& mesh);

/// About the center of the bounding box.
FramingSphere framingSphere(std::span<const Eigen::Vector3f> positions);

}  // namespace stipple::scenes
