#include "plugins/texture_synthesis/chebyshev.h"

#include <algorithm>
#include <cmath>

namespace stipple {

Band dampedBand(int sweeps, double tolerance, double usual, double largest) {
  // T_sweeps(middle / half width) = 1 / tolerance.
  const double ratio = std::cosh(std::acosh(1 / tolerance) / sweeps);
  const double lower = usual * (ratio - 1) / (ratio + 1);
  if (lower + usual >= largest) return {lower, usual};
  return {largest * (1 - 1 / ratio) / 2, largest * (1 + 1 / ratio) / 2};
}

std::vector<Sweep> chebyshevSweeps(int sweeps, const Band& band) {
  const double middle = 0.5 * (band.upper + band.lower);
  const double halfWidth = std::max(0.5 * (band.upper - band.lower), 1e-9 * middle);
  std::vector<Sweep> result = {{0, 1 / middle}};
  double rho = halfWidth / middle;
  for (int sweep = 1; sweep < sweeps; ++sweep) {
    const double next = 1 / (2 * middle / halfWidth - rho);
    result.push_back({next * rho, 2 * next / halfWidth});
    rho = next;
  }
  return result;
}

}  // namespace stipple
