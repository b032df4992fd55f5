#pragma once

#include <vector>

namespace stipple {

/// Sweeps u'' = u' + momentum (u' - u) + gain D^-1 (b - A u') by the Chebyshev iteration (Golub and Varga
/// 1961).
struct Sweep {
  double momentum, gain;
};

/// The interval of eigenvalues of D^-1 A that so many sweeps damp to a share of `tolerance`. Upper end:
/// `usual`, or as far beyond as it takes for no eigenvalue up to `largest` to grow; all those between 0 and
/// lower + upper shrink.
struct Band {
  double lower, upper;
};
Band dampedBand(int sweeps, double tolerance, double usual, double largest);

/// What damps that band best.
std::vector<Sweep> chebyshevSweeps(int sweeps, const Band& band);

}  // namespace stipple
