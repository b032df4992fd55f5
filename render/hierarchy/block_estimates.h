#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/progress.h"
#include "render/hierarchy/build.h"

namespace stipple {

/// Leaves in one block share these.
struct BlockEstimate {
  float spacing = 0;                                  ///< root of the area a point stands for, length
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< sign arbitrary
};

inline constexpr Index kLeavesOfBlock = 16;

/// Spacing and normal of every aligned block of 16 slots, for the first picture: median distance to the third
/// nearest leaf of the block (about one spacing on a grid as on random points), plane by moments. The last
/// block may be smaller; blocks of fewer than 4 distinct places take the spacing of the block before.
std::vector<BlockEstimate> estimateBlocks(std::span<const PlacedPoint> leaves,
                                          const Progress* progress = nullptr);

}  // namespace stipple
