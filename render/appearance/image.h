#pragma once

#include <vector>

#include "core/points/attribute.h"

namespace stipple {

/// Rows from the top, straight alpha, sRGB.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgba8> pixels;

  Rgba8& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Rgba8& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

}  // namespace stipple
