#pragma once

#include "plugins/texture_synthesis/reaction.h"

namespace stipple {

/// What one time step makes of small waves about the homogeneous state, from the linearized step itself
/// (diffusion implicit), so that the time step counts.
struct PatternModes {
  double wavelength = 0;         ///< cells, of the wave that grows fastest
  double growth = 0;             ///< of that wave per unit of time; below 0: all waves die
  double homogeneousFactor = 1;  ///< by which a change that is the same everywhere grows in one step
};

PatternModes findModes(const PatternSystem& system, double timeStep);

/// Throws InvalidInput with one sentence where the homogeneous state would blow up at this time step (naming
/// the largest that would do), or where no wave grows although the pattern starts from noise.
void requirePattern(Pattern pattern, const PatternSystem& system, double timeStep);

}  // namespace stipple
