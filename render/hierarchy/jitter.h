#pragma once

#include <glm/vec2.hpp>

namespace stipple {

/// Shift in pixels, within half a pixel, of frame `index` of many whose mean is shown (Halton 1960, bases 2
/// and 3): any first few are spread evenly.
glm::vec2 jitterOfFrame(int index);

}  // namespace stipple
