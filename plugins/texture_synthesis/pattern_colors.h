#pragma once

#include <span>
#include <vector>

#include "core/points/attribute.h"

namespace stipple {

/// How much of the figure there is at each value, in [0, 1]: a smooth step from the 5 % to the 95 % quantile
/// (of all values where these are equal). All 0 where the values do not vary.
std::vector<float> figureShares(std::span<const float> values, bool figureIsHigh);

/// The two colors mixed in linear light.
std::vector<Rgba8> blendColors(std::span<const float> shares, Rgba8 ground, Rgba8 figure);

}  // namespace stipple
