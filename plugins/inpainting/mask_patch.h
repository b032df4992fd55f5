#pragma once

#include <span>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// A part of a point set as a point set of its own, positions and triangles only.
struct MaskPatch {
  std::vector<Index> rows;  ///< of the whole set, ascending
  PointSet points;
};

/// The masked rows (ascending, not empty) and all rows so near that they have a say in the matrices there:
/// fans look at up to 64 neighbors, and so do those of their own neighbors, with which they have to agree.
/// A discretization of the patch is that of the whole set, at the mask and its rim.
MaskPatch cutPatch(const PointSet& whole, std::span<const Index> masked, const Progress* progress = nullptr);

/// All rows.
MaskPatch wholePatch(const PointSet& whole);

}  // namespace stipple
