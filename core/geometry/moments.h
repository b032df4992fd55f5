#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/neighborhoods.h"

namespace stipple {

/// Zeroth and first moment of the site and its neighbors, normalized by their number (Section 5, Eq. (4)-(7);
/// the paper's formulas lack the factor 1/|N|). eigenvalues in length^2, l0 >= l1 >= l2; axes are columns w0,
/// w1, n: an orthonormal right-handed frame whose n is the normal up to sign.
struct Moments {
  Eigen::Vector3f centerOffset;  ///< barycenter minus the site
  Eigen::Vector3f eigenvalues;   ///< l0, l1, l2
  Eigen::Matrix3f axes;
  float radius = 0;  ///< eps: distance to the last neighbor
};

std::vector<Moments> fitMoments(const Sites& sites, const Neighborhoods& neighborhoods,
                                const Progress* progress = nullptr);
/// Of the k >= 1 nearest neighbors, which are not kept. Throws InvalidInput.
std::vector<Moments> fitMoments(const Sites& sites, int k, const Progress* progress = nullptr);

/// C = 1 / (1 + 1e4 s^2), s = |M0 - x| l2 / (eps l0): in (0, 1], 1 where flat, small at creases (Eq. (12)
/// with G(0) = 1). Scale invariant. 1 where the neighborhood is degenerate (fewer than 3 neighbors, l0 = 0).
std::vector<float> classify(const std::vector<Moments>& moments);

/// Standard deviation of the noise across the surface in units of the mean spacing: median over a fixed
/// sample of sites of the residual of a local quadratic fit to k neighbors, corrected for its degrees of
/// freedom.
double estimateNoise(const Sites& sites, int k = 30);

}  // namespace stipple
