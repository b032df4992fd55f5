#pragma once

#include <Eigen/Core>
#include <vector>

#include "plugins/inpainting/hole.h"

namespace stipple {

/// Where edges of the values are looked for. known: what is known around the mask, continued into it, so that
/// edges which end at the rim aim at each other. current: what stands inside it now.
enum class EdgeSource { kKnown, kCurrent };

/// Diffusion tensors that carry little across edges of the values: A = C (I - (1 - a) d d^T), C the
/// classifier, d the direction in which the values change most: the first axis of the structure tensor J, the
/// sum over channels of grad u grad u^T, averaged over neighboring fans (Weickert 1998). a falls from 1 where
/// J has no preferred direction (noise, corners) to .001 where its eigenvalues l0 > l1 tell of one edge.
std::vector<Eigen::Matrix3d> edgeTensors(const Hole& hole, EdgeSource source,
                                         const Progress* progress = nullptr);

}  // namespace stipple
