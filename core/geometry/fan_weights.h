#pragma once

#include <span>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// Largest weight of an edge: the cotangent of an angle of half a millionth, between points that lie closer
/// than floats tell points apart at the other end of the edge. Beside larger ones rounding swallows the
/// masses, and factorizations break down.
constexpr double kMostWeight = 1e6;

/// Per spoke (parallel to fans.neighbors): half the sum of the cotangents facing it, of the triangles of its
/// own fan. Equal to |Voronoi edge| / |spoke| where the fan is a Delaunay star; dimensionless, >= 0 but for
/// scheme paper.
struct FanWeights {
  std::vector<double> weights;
  std::vector<double>
      mass;  ///< m: Voronoi cell area where the fan closes, else a third of its triangles; length^2, > 0
};

/// Cotangents are taken in the tangent plane, where the distances from the site are those in space (metric
/// unfolded) or projected; for scheme paper in space or projected. On curved surfaces the unfolded plane is
/// closer to the surface than the flat triangles are. A site that no triangle reaches is tied to its spokes.
FanWeights weighFans(const Sites& sites, const Fans& fans, std::span<const Eigen::Vector3f> normals,
                     const DiscretizationOptions& options, const Progress* progress = nullptr);

/// Raises masses to a thousandth of their mean; where there is no area at all, to spacing^2.
void floorMass(const Sites& sites, std::vector<double>& mass);

}  // namespace stipple
