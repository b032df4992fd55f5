#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// Normals of one sense, and how far the fans agreed on it.
struct Orientation {
  std::vector<Eigen::Vector3f> normals;  ///< m x 3, unit: those of the discretization or their opposites
  Index votes = 0;                       ///< pairs of sites whose fans share triangles that agree on a sense
  Index conflicts = 0;                   ///< votes that the signs go against; 0 on a clean scan
};

/// Sums of the unit normals that the points of each site have in the attribute `normal`, 0 where not finite.
/// Empty where there is none.
std::vector<Eigen::Vector3f> sumNormals(const Sites& sites, const PointSet& points);

/// Gives the normals of a discretization consistent signs. The attribute `normal` of the points decides where
/// it is there and makes sense (not random signs, not one constant); for scheme mesh else the winding of the
/// triangles. Elsewhere pairs of fans vote: a triangle that both have runs the same way round in both iff
/// their normals agree. A maximum spanning tree follows the strongest votes, and Hoppe et al. 1992 (the most
/// parallel normals) joins what no vote connects. A connected part that no normal of the file reaches faces
/// up at its top. The signs depend on the positions and the attribute alone, not on the order of the rows.
Orientation orientNormals(const Discretization& d, const PointSet& points,
                          const Progress* progress = nullptr);

}  // namespace stipple
