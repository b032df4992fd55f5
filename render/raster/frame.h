#pragma once

#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "core/parallel.h"

namespace stipple {

/// What was drawn, rows from the top.
struct FrameBuffers {
  static constexpr Index kNoNode = static_cast<Index>(-1);
  static constexpr float kEmpty = std::numeric_limits<float>::infinity();

  int width = 0, height = 0;
  std::vector<glm::vec4> light;  ///< linear red, green, blue; coverage 0 or 1
  std::vector<float> depth;      ///< world units along the line of sight, kEmpty: nothing
  std::vector<Index> nodes;      ///< kNoNode: nothing

  void resize(int w, int h) {
    width = w;
    height = h;
    const std::size_t pixels = static_cast<std::size_t>(w) * h;
    light.resize(pixels);
    depth.resize(pixels);
    nodes.resize(pixels);
  }
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
};

}  // namespace stipple
