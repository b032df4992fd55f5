#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// The triangles of a point set as they are drawn; all spans by point.
struct SurfaceMesh {
  std::span<const Eigen::Vector3f> positions;
  std::span<const Eigen::Vector3f> normals;
  std::span<const Rgba8> colors;
  std::span<const Triangle> triangles;
};

}  // namespace stipple
