#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/sites.h"

namespace stipple {

/// The labels of given seeds for every file row, 0 where there is none. Throws InvalidInput where the
/// attribute is missing, holds anything but whole numbers, or no seed at all.
std::vector<std::int32_t> readSeeds(const PointSet& points, const std::string& attribute);

/// The same for sites; of several rows at one place the first with a seed counts.
std::vector<std::int32_t> gatherSeeds(const Sites& sites, const std::vector<std::int32_t>& seedOfPoint);

/// Numbers labels 1, 2, ... by falling number of points, ties by the label at hand; 0 stays. Returns their
/// number.
int renumberBySize(std::vector<std::int32_t>& labels);

}  // namespace stipple
