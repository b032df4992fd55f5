#pragma once

#include <cstdint>

namespace stipple {

/// Straight alpha, channels in the order of the target's memory (the lowest byte first).
struct SourceColor {
  std::uint8_t channels[3] = {};
  std::uint8_t alpha = 255;
};

/// source * alpha + target * (1 - alpha) in every channel, alpha's own included, rounded once. Opaque stays
/// opaque; premultiplied stays premultiplied.
void blendPixel(std::uint32_t& target, const SourceColor& color);

/// The same for a row of pixels.
void blendSpan(std::uint32_t* target, int count, const SourceColor& color);

/// The same with the color's alpha times a coverage (0..255) for each pixel.
void blendCoverage(std::uint32_t* target, int count, const SourceColor& color, const std::uint8_t* coverage);

/// round(a * b / 255), exact.
inline std::uint8_t timesUnit(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t x = a * b + 128;
  return static_cast<std::uint8_t>((x + (x >> 8)) >> 8);
}

}  // namespace stipple
