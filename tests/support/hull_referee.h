#pragma once

#include <span>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// Triangles of CGAL's convex hull, which is the Delaunay mesh of points on a sphere. Throws where a corner
/// is no point.
std::vector<Triangle> hullTriangles(std::span<const Eigen::Vector3f> points);

}  // namespace stipple
