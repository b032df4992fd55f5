#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/fan_votes.h"
#include "core/points/point_set.h"

namespace stipple {

/// The fan of a site by the accepted triangles, counterclockwise about its normal.
struct PatchFan {
  Index site;
  bool open;
  std::vector<Index> spokes;
};

struct ResolvedPatch {
  std::vector<PatchFan> fans;       ///< of the sites where the triangles form one cycle, or one chain
  std::vector<Triangle> triangles;  ///< accepted, beside those that all three fans share; winding arbitrary
};

/// Resolves one connected set of disputed triangles.
ResolvedPatch resolvePatch(std::span<const Eigen::Vector3f> positions,
                           std::span<const Eigen::Vector3f> normals, const Fans& fans,
                           std::span<const VotedTriangle> disputed);

/// Closes a loop of edges that have one triangle each by cutting ears off, that of the smallest circumradius
/// first; `around` are all triangles that touch its sites. Returns those that it added: no edge gets a third
/// one, none folds over and, where that closes the loop, none overlaps another in a tangent plane. What is
/// left over stays open.
std::vector<Triangle> closeLoop(std::span<const Eigen::Vector3f> positions,
                                std::span<const Eigen::Vector3f> normals, std::span<const Index> loop,
                                std::span<const Triangle> around);

}  // namespace stipple
