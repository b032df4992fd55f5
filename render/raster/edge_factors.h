#pragma once

#include <cstddef>

namespace stipple {

/// Pixels that rows of depths and factors must have to spare at their end.
inline constexpr int kEdgePadding = 8;

/// log2 of depths, or `scale` times them; infinity stays.
void scaleDepths(const float* depths, std::size_t count, bool logarithmic, float scale, float* result);

/// Factor in [1/4, 1] for `count` pixels: exp(-strength r), r the mean over eight neighbors (one and two
/// pixels away along the axes) of how much nearer they are in the given depths.
void edgeFactors(const float* depths, std::ptrdiff_t stride, int count, float strength, float* factors);

}  // namespace stipple
