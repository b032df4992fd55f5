#pragma once

#include <Eigen/Core>

#include "core/geometry/discretization.h"

namespace stipple {

/// What the light on a point can depend on, as far as the shape of the surface tells; rows are sites. The
/// normal n (3 numbers) and the harmonics of second order in it (5): the light of any distant surroundings on
/// a matt surface is a combination of these and a constant, to 1 % (Ramamoorthi and Hanrahan 2001). Then how
/// far the site stands out of the mean of its surroundings along n, in mean spacings, at three scales (3):
/// hollows are darker. Normals are turned to one side, whichever.
constexpr int kReliefSize = 11;
using Relief = Eigen::Matrix<double, Eigen::Dynamic, kReliefSize, Eigen::RowMajor>;
Relief describeRelief(const Discretization& d, const Progress* progress = nullptr);

}  // namespace stipple
