#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/local_fan.h"

namespace stipple {

/// Neighbors of the origin in CGAL's Delaunay triangulation of the origin and the points, counterclockwise;
/// empty where the origin is on the hull.
std::vector<Index> delaunayStar(const std::vector<PlanePoint>& points);

/// The same cyclic sequence.
inline bool sameCycle(std::vector<Index> a, std::vector<Index> b) {
  if (a.size() != b.size() || a.empty()) return a.size() == b.size();
  std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
  std::rotate(b.begin(), std::min_element(b.begin(), b.end()), b.end());
  return a == b;
}

}  // namespace stipple
