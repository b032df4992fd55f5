#pragma once

#include <memory>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// Distances to the triangles of a mesh, by CGAL's AABB tree.
class SurfaceReferee {
 public:
  explicit SurfaceReferee(const PointSet& mesh);
  ~SurfaceReferee();
  double distanceTo(const Eigen::Vector3d& place) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace stipple
