#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// Tangential gradient (m x 3) of the interpolation of Eq. (15), a(x) = sum a(q) w(|x - q| / d) / sum
/// w(|x - q| / d) with w(r) = 2 r^3 - 3 r^2 + 1 below r = 1: differentiated, where the paper takes forward
/// differences. Too flat by a factor that hardly varies over an even scan. 0 where nothing lies within d.
std::vector<Eigen::Vector3d> radialGradient(const Discretization& d, std::span<const double> values,
                                            double radius, const Progress* progress = nullptr);

}  // namespace stipple
