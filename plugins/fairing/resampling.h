#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// Mean distance of each site to the neighbors in its fan, length; 0 where it has none.
std::vector<double> localSpacings(const Discretization& d);

/// What restores the density that the surface had (Section 9 of the paper).
struct Resampling {
  std::vector<Index> removed;                  ///< sites, ascending
  std::vector<std::array<Index, 2>> inserted;  ///< between these two sites
};

/// Removes sites where the surface shrank to less than .8 of its rest spacing, and inserts one between a site
/// and its farthest neighbor where it stretched to more than 1.3; next to what changes nothing else does this
/// time. `rest`: spacings that the sites are to have, m; 0: the site takes no part.
Resampling planResampling(const Discretization& d, std::span<const double> rest);

}  // namespace stipple
