#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// Tangential gradient of one value a site (m x 3, units of the value per length): the mean of the gradients
/// of the triangles round the site, in space, weighted by their angles there, without its part along the
/// normal. Exact for linear functions on a plane; 0 where a site has no triangle. The triangles are those of
/// the fan, for scheme mesh those of the file.
std::vector<Eigen::Vector3d> fanGradient(const Discretization& d, std::span<const double> values,
                                         const Progress* progress = nullptr);

}  // namespace stipple
