#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/moments.h"

namespace stipple {

/// features: A = diag(max(C', min(1, 2 (l0 - l1) / l0)), C') with C' = H(C), the second term only along a
/// crease. paper: A = diag(1, C) (Eq. (16)). isotropic: A = 1.
enum class FairingTensor { kFeatures, kPaper, kIsotropic };

/// Value of the classifier on a crease that turns by `angle` (radians): C = 1 / (1 + 141 sin^6(angle / 2)).
double classifierOfCrease(double angle);

/// The tensors of the sites, 3 x 3 in world coordinates: along the direction of the largest moment, and
/// across it. `gamma`: classifier up to which nothing flows across, H(C) = sqrt((C - gamma) / (1 - gamma))
/// above. `noise`: its standard deviation, length; tensor features allows for what it adds to the moments.
std::vector<Eigen::Matrix3d> fairingTensors(const std::vector<Moments>& moments, FairingTensor tensor,
                                            double gamma, double noise);

}  // namespace stipple
