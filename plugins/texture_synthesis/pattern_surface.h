#pragma once

#include <memory>
#include <string>

#include "core/geometry/discretization.h"
#include "plugins/texture_synthesis/pair_diffusion.h"

namespace stipple {

/// The surface that a pattern grows on.
struct PatternSurface {
  Discretization discretization;
  double area = 0, spacing = 0, diagonal = 0;  ///< of the sites; spacing = sqrt(area / sites); length
  double finest = 1;  ///< smallest width of the guided pattern, relative to one without guides
  std::unique_ptr<PairDiffusion> diffusion = {};  ///< of waves of the wanted size
};

/// Attributes that bend the pattern; empty: none.
struct PatternGuides {
  std::string sizeBy, directionBy;
};

/// Throws InvalidInput where a guide cannot be used.
void checkGuides(const PointSet& points, const PatternGuides& guides);

/// Throws InvalidInput where there is no surface.
PatternSurface buildPatternSurface(const PointSet& points, const DiscretizationOptions& options,
                                   Progress& progress);

/// Makes `diffusion` for these guides: div(A grad u) with A = 1 where there are none, 4^v where the size is
/// scaled by 2^v, drawn out along directions with the determinant kept.
void guideDiffusion(PatternSurface& surface, const PointSet& points, const PatternGuides& guides,
                    const Progress* progress);

}  // namespace stipple
