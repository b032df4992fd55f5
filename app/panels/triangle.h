#pragma once

#include <cstdint>

#include "app/panels/pixel_target.h"

namespace stipple {

/// x, y in pixels, u, v in texels.
struct RasterVertex {
  float x = 0, y = 0, u = 0, v = 0;
  std::uint32_t color = 0;  ///< straight alpha, lowest byte first in the target's memory

  friend bool operator==(const RasterVertex&, const RasterVertex&) = default;
};

/// What is drawn onto, with what, and where.
struct RasterScene {
  PixelTarget target;
  AlphaTexture atlas;
  PixelRectangle scissor;  ///< within the target
};

/// Colors and texels vary linearly; texels are filtered bilinearly.
void drawTriangle(const RasterScene& scene, const RasterVertex (&corners)[3]);

/// A rectangle of one color, from its upper left to its lower right corner, with the texture stretched over
/// it.
void drawRectangle(const RasterScene& scene, const RasterVertex& upperLeft, const RasterVertex& lowerRight);

/// The first pixel whose center is not left of (above) x.
int firstPixelFrom(float x);

}  // namespace stipple
