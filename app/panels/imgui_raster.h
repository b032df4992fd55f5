#pragma once

#include <cstdint>
#include <vector>

#include "app/panels/pixel_target.h"

struct ImDrawData;

namespace stipple {

/// Draws what Dear ImGui made onto a picture, without a graphics card. A pixel belongs to a triangle where
/// its center does, to the left and upper one of two that share an edge. `atlas` is the only texture; user
/// callbacks are passed over. Returns disjoint rectangles that hold every pixel touched.
std::vector<PixelRectangle> rasterize(const ImDrawData& drawing, const AlphaTexture& atlas,
                                      const PixelTarget& target);

/// Equal for equal drawings: where it is the same as for the last frame, nothing has to be painted again.
std::uint64_t fingerprintOf(const ImDrawData& drawing);

}  // namespace stipple
