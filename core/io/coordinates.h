#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// The origin of a point set with these file coordinates: 0 unless storing them as float would lose more than
/// 1e-6 of the extent, else near the center of the bounds, a multiple of a power of two. Coordinates that are
/// not finite, or beyond the range of float, do not count.
Eigen::Vector3d chooseOrigin(std::span<const Eigen::Vector3d> coordinates);

/// Positions relative to the origin; not finite where the coordinate is not, or beyond the range of float.
std::vector<Eigen::Vector3f> relativeTo(const Eigen::Vector3d& origin,
                                        std::span<const Eigen::Vector3d> coordinates);

/// The way back to one file coordinate; keeps the sign of a zero.
inline double fileCoordinate(double origin, float position) {
  return origin == 0 ? static_cast<double>(position) : origin + static_cast<double>(position);
}

/// Rows with a coordinate that is not finite, ascending.
std::vector<Index> rowsNotFinite(std::span<const Eigen::Vector3f> positions);

}  // namespace stipple
