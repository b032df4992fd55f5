#pragma once

#include <span>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// Per spoke (parallel to fans.neighbors): half the sum of the cotangents facing it, of the triangles of its own fan. Equal
/// to |Voronoi edge| / |spoke| where the fan is a Delaunay star; dimensionless, >= 0 but for scheme paper.
struct FanWeights {
  std::vector<double> weights;
  std::vector<double> mass;  ///< m: Voronoi cell area where the fan closes, else a third of its triangles; length^2, > 0
};

/// Cotangents are taken in the tangent plane, or in space where fans agree (resolved) and distances are unfolded; there
/// a negative sum gives way to the weight in the tangent plane. A site that no triangle reaches is tied to its spokes.
FanWeights weighFans(const Sites& sites, const Fans& fans, std::span<const Eigen::Vector3f> normals,
                     std::span<const std::uint8_t> resolved, const DiscretizationOptions& options,
                     const Progress* progress = nullptr);

/// Raises masses to a thousandth of their mean; where there is no area at all, to spacing^2.
void floorMass(const Sites& sites, std::vector<double>& mass);

}  // namespace stipple
