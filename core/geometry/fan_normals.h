#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/fans.h"

namespace stipple {

/// Unit normals of the triangles of each fan, weighted by area, with the sites moved to `places` (m x 3).
/// Each is on the side of the one in `along` (m), and is that one where the fan has no area.
std::vector<Eigen::Vector3f> fanNormals(const Fans& fans, const Eigen::MatrixXd& places,
                                        std::span<const Eigen::Vector3f> along,
                                        const Progress* progress = nullptr);

}  // namespace stipple
