#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// Adds the fan of triangles of a polygon (from its first corner). Corners below 0 or beyond `pointCount`
/// make the polygon unusable: nothing is added and false returned. Polygons of fewer than three corners add
/// nothing.
bool appendPolygon(std::span<const std::int64_t> corners, Index pointCount, std::vector<Triangle>& triangles);

/// Adds the triangles of strips separated by negative corners, turned so that all look the same way;
/// triangles with a repeated corner are what joins strips and are left out. False where a corner is beyond
/// `pointCount`.
bool appendStrips(std::span<const std::int64_t> corners, Index pointCount, std::vector<Triangle>& triangles);

}  // namespace stipple
