#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "plugins/inpainting/inpainting.h"

namespace stipple {

using Settings = std::vector<std::pair<std::string, ParameterValue>>;

Parameters inpaintingSettings(const Settings& settings);

/// Runs the operator to its end.
PointSet inpaint(const PointSet& points, const std::vector<Index>& masked, const Settings& settings,
                 Report* report = nullptr);

/// The rows within a distance of a place, ascending.
std::vector<Index> rowsAround(const PointSet& points, const Eigen::Vector3f& center, float radius);

using Texture = std::function<double(const Eigen::Vector3f&)>;

/// Root mean square error in a round hole in the middle of the unit square, of radius 12 mean spacings of
/// 10000 points, where `texture` was lost.
double holeError(const Texture& texture, const std::string& method, std::uint64_t seed);

}  // namespace stipple
