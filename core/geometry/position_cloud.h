#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

namespace stipple {

/// Positions as nanoflann asks for them, for sources of this room that grow a tree over them. Keeps no copy.
struct PositionCloud {
  std::span<const Eigen::Vector3f> positions;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  float kdtree_get_pt(std::size_t row, std::size_t axis) const {
    return positions[row][static_cast<int>(axis)];
  }
  /// No bounds are known beforehand: nanoflann finds them itself.
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

}  // namespace stipple
