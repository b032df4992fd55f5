#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/parallel.h"

namespace stipple {

/// For each query the row of the nearest of `positions` (in space); of equally near ones the lowest. Throws
/// InvalidInput where there are no positions.
std::vector<Index> findNearestPoints(std::span<const Eigen::Vector3f> positions,
                                     std::span<const Eigen::Vector3f> queries,
                                     const Progress* progress = nullptr);

}  // namespace stipple
