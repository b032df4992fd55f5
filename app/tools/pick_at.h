#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace stipple {

/// What is seen at a pixel.
struct Picked {
  glm::vec3 position{};  ///< world
  float depth = 0;       ///< along the view direction, world units
};

/// Nothing where the background is seen, or outside of the picture.
using PickAt = std::function<std::optional<Picked>(const glm::vec2& px)>;

}  // namespace stipple
