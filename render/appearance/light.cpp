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

const std::array<std::uint8_t, kEncodeSteps>& encodeTable() {
  static const std::array<std::uint8_t, kEncodeSteps> table = [] {
    std::array<std::uint8_t, kEncodeSteps> values{};
    for (int i = 0; i < kEncodeSteps; ++i) {
      const float linear = static_cast<float>(i) / (kEncodeSteps - 1);
      values[i] = static_cast<std::uint8_t>(std::lround(255 * std::min(srgbFromLinear(linear), 1.f)));
    }
    return values;
  }();
  return table;
}

}  // namespace stipple
