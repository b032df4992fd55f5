#pragma once

#include <vector>

#include "plugins/inpainting/hole.h"

namespace stipple {

/// A part of the mask that is filled at once, and what lies around it.
struct MaskPart {
  std::vector<Index> targets;  ///< sites of the hole, ascending
  std::vector<Index> rows;     ///< of the whole point set, ascending: within several radii of the part
};

/// Splits `targets` (ascending sites of the hole that touch what is known) into parts that are at least 8
/// spacings apart; those that are too large for memory are cut. `spacing` in model units.
std::vector<MaskPart> splitMask(const PointSet& points, const Hole& hole, std::span<const Index> targets,
                                float spacing, const Progress* progress = nullptr);

/// Rows of everything are sites: the distinct places of the part's rows, without those that are neither known
/// nor masked.
struct Surround {
  enum class Kind : std::uint8_t { kKnown, kTarget, kOther };  // other: of another part, or without a rim
  Sites sites;
  std::vector<Kind> kinds;
  std::vector<Index> holeSites;  ///< of those that are not known
  Eigen::MatrixXd values;        ///< sites x channels: the attribute's where known, else the hole's
};

Surround gatherSurround(const PointSet& points, const Attribute& attribute, const Region& region,
                        const Hole& hole, const MaskPart& part);

}  // namespace stipple
