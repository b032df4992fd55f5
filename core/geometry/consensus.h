#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/fans.h"

namespace stipple {

/// Votes disagreeing fans into one conforming set of triangles, patch by patch: triangles of three fans
/// stand; those of two, then of one, are taken by ascending circumradius unless an edge would get a third
/// triangle, the surface would fold over, or sectors in a tangent plane would overlap; small holes are
/// closed. A site's fan is replaced only where the accepted triangles form one cycle round it (or one chain,
/// if its own fan was open). The result depends on nothing outside a patch. Returns m flags: the fan consists
/// of accepted triangles.
std::vector<std::uint8_t> reachConsensus(std::span<const Eigen::Vector3f> positions,
                                         std::span<const Eigen::Vector3f> normals, Fans& fans,
                                         const Progress* progress = nullptr);

}  // namespace stipple
