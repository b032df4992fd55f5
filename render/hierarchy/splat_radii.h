#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/points/point_set.h"
#include "core/progress.h"

namespace stipple {

/// What splats of points need to know of the surface, by point.
struct SurfaceEstimate {
  std::vector<float> radii;              ///< of discs that leave no hole and blend, > 0
  std::vector<float> areas;              ///< that a point stands for, length^2, > 0
  std::vector<Eigen::Vector3f> normals;  ///< unit; see normalsOfFile; else of the tangent plane (any sign)
};

/// Radii from the attribute `radius` where it is plausible (within a factor of eight of the spacing), else
/// from local Delaunay fans: a disc reaches the farthest corner of its point's Voronoi cell, is at most three
/// times as large as those of its neighbors, and does not bridge gaps that the fans leave open.
SurfaceEstimate estimateSurface(const PointSet& points, const Progress* progress = nullptr);

/// The normals that the points bring along: `display_normal`, else `normal`, else the means of their
/// triangles'; 0 where there is none, empty where no point has one.
std::vector<Eigen::Vector3f> normalsOfFile(const PointSet& points);

}  // namespace stipple
