#include "render/appearance/light.h"

#include <algorithm>

namespace stipple {

const std::array<float, 256>& linearTable() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (int i = 0; i < 256; ++i) values[i] = linearFromSrgb(static_cast<float>(i) / 255);
    return values;
  }();
  return table;
}

std::uint8_t encodeSrgb(float linear) {
  return static_cast<std::uint8_t>(std::lround(255 * srgbFromLinear(std::clamp(linear, 0.f, 1.f))));
}

}  // namespace stipple
