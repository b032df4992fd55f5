#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plugins/texture_synthesis/pattern_surface.h"

namespace stipple {

/// Reproducible irregularities in [-1, 1), one a site: a hash of its number and the seed.
std::vector<float> irregularities(Index sites, std::uint64_t seed);

/// Sites where the classifier lies within the lowest `fraction` of its range (between its 1 % and 99 %
/// quantiles: outliers have no say). Throws InvalidInput where the surface has no edges.
std::vector<Index> seedsAtEdges(const Sites& sites, double fraction, const Progress* progress);

/// Sites where the attribute is not 0. Throws InvalidInput where there is none.
std::vector<Index> seedsFromAttribute(const PointSet& points, const Sites& sites,
                                      const std::string& attribute);

/// Sites of discs thrown at random: about one disc on every (4 radius)^2 of the surface.
std::vector<Index> scatteredDiscs(const PatternSurface& surface, double radius, std::uint64_t seed);

}  // namespace stipple
