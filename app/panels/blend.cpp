#include "app/panels/blend.h"

#include <algorithm>
#include <array>

namespace stipple {

namespace {

// Four pixels at a time: enough for the vector units of any machine that the compiler knows of.
constexpr int kBlock = 16;

std::uint32_t opaqueWord(const SourceColor& color) {
  return color.channels[0] | color.channels[1] << 8 | color.channels[2] << 16 | 0xff000000u;
}

// source * alpha plus a half, so that the division by 255 rounds. All sums stay below 2^16.
std::array<std::uint16_t, 4> weighted(const SourceColor& color) {
  const auto times = [&](std::uint8_t channel) { return std::uint16_t(channel * color.alpha + 128); };
  return {times(color.channels[0]), times(color.channels[1]), times(color.channels[2]), times(255)};
}

std::uint8_t blended(std::uint8_t target, std::uint16_t source, std::uint16_t rest) {
  const std::uint16_t x = std::uint16_t(target * rest + source);
  return static_cast<std::uint8_t>(std::uint16_t(x + (x >> 8)) >> 8);
}

}  // namespace

void blendPixel(std::uint32_t& target, const SourceColor& color) {
  const std::array<std::uint16_t, 4> source = weighted(color);
  const std::uint16_t rest = 255 - color.alpha;
  std::uint32_t result = 0;
  for (int i = 0; i < 4; ++i) {
    const auto channel = static_cast<std::uint8_t>(target >> (8 * i));
    result |= std::uint32_t(blended(channel, source[i], rest)) << (8 * i);
  }
  target = result;
}

void blendSpan(std::uint32_t* target, int count, const SourceColor& color) {
  if (color.alpha == 255) {
    std::fill_n(target, count, opaqueWord(color));
    return;
  }
  const std::array<std::uint16_t, 4> source = weighted(color);
  const std::uint16_t rest = 255 - color.alpha;
  std::uint16_t repeated[kBlock];
  for (int i = 0; i < kBlock; ++i) repeated[i] = source[i & 3];
  auto* bytes = reinterpret_cast<std::uint8_t*>(target);
  int left = 4 * count;
  for (; left >= kBlock; left -= kBlock, bytes += kBlock) {
    for (int i = 0; i < kBlock; ++i) bytes[i] = blended(bytes[i], repeated[i], rest);
  }
  for (int i = 0; i < left; ++i) bytes[i] = blended(bytes[i], repeated[i], rest);
}

void blendCoverage(std::uint32_t* target, int count, const SourceColor& color, const std::uint8_t* coverage) {
  for (int i = 0; i < count; ++i) {
    if (coverage[i] == 0) continue;
    SourceColor covered = color;
    covered.alpha = timesUnit(color.alpha, coverage[i]);
    blendPixel(target[i], covered);
  }
}

}  // namespace stipple
