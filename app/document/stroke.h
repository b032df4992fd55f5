#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/points/point_set.h"
#include "core/progress.h"

namespace stipple {

enum class StrokeTool { kPaint, kErase, kSmooth };
/// "paint", "erase", "smooth".
const char* nameOf(StrokeTool tool);

/// One touch of the brush: a place in file coordinates, a pressure in [0, 1] that scales the strength, and
/// the share in (0, 1] of the stroke's radius.
struct Dab {
  Eigen::Vector3d position;
  double pressure = 1, size = 1;
};

/// A brush stroke without a camera. `value` has 1 number for float and integer attributes, 3 for vectors, 3
/// or 4 in 0..255 for colors; only painting needs one.
struct Stroke {
  StrokeTool tool = StrokeTool::kPaint;
  std::string attribute;
  std::vector<double> value = {};
  double radius = 0;    ///< length along the surface, > 0
  double strength = 1;  ///< share of the value that a dab lays down at its center, in (0, 1]
  std::vector<Dab> dabs = {};
  std::string within = {};  ///< an attribute: only points where it is not 0. Empty: all
};

/// The points with the stroke laid down. A dab starts at the point nearest to it, if that is within
/// its radius, and reaches the points within `radius` along the surface (shortest paths over the 12 nearest
/// neighbors). Integers inside are set; floats, vectors and colors blend toward the value with a smooth
/// falloff. Erasing paints 0, or white for colors; smoothing the mean of the neighbors in the graph, for
/// integers what most of them and the point have. A missing attribute is made by painting: colors for 3 or 4
/// numbers, otherwise int where the value is whole and float where not. Throws InvalidInput where the value
/// does not suit the attribute, or an attribute is missing.
PointSet applyStroke(const PointSet& points, const Stroke& stroke, Progress& progress);

}  // namespace stipple
