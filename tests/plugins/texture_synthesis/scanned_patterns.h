#pragma once

#include <string>

#include "core/points/point_set.h"

namespace stipple {

PointSet readScan(const std::string& path);

/// Area of the triangles of the file: an account of the surface that owes nothing to fans.
double meshArea(const PointSet& mesh);

/// About one row in `share`, scattered over the file.
PointSet thinned(const PointSet& points, Index share);

/// Distance of spots by their number on the area, over the wanted size.
double relativeSpotDistance(const PointSet& points, double size, double area);

}  // namespace stipple
