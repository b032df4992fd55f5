#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/fans.h"
#include "core/points/point_set.h"

namespace stipple {

/// A triangle that is not in the fans of all three corners; corners ascending.
struct VotedTriangle {
  Triangle corners;
  int votes;  ///< fans that have it: 1 or 2
};

/// The fan of a site by the accepted triangles, counterclockwise about its normal.
struct PatchFan {
  Index site;
  bool open;
  std::vector<Index> spokes;
};

/// Resolves one connected set of disputed triangles; returns the fans of the sites where that succeeded.
std::vector<PatchFan> resolvePatch(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                                   const Fans& fans, std::span<const VotedTriangle> disputed);

}  // namespace stipple
