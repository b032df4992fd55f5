#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/progress.h"
#include "render/hierarchy/build.h"

namespace stipple {

/// Leaves of one aligned block share their estimates.
inline constexpr Index kLeavesOfBlock = 16;

/// Root of the area that a point stands for, by block, for the first picture: median distance to the third
/// nearest leaf of the block (about one spacing on a grid as on random points). The last block may be
/// smaller; blocks of fewer than 4 distinct places take the spacing of the block before.
std::vector<float> estimateBlockSpacings(std::span<const PlacedPoint> leaves,
                                         const Progress* progress = nullptr);

/// Normal of the plane through the leaves of a block, unit, sign arbitrary.
Eigen::Vector3f fitBlockNormal(std::span<const PlacedPoint> leaves, std::size_t block);

}  // namespace stipple
