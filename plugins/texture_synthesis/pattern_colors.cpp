#include "plugins/texture_synthesis/pattern_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stipple {

namespace {

// Less than this, relative to the values, is no pattern yet.
constexpr float kFlat = 1e-4f;

// The curve of sRGB (IEC 61966-2-1) and its inverse.
double toLinear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
double toEncoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

std::uint8_t mix(std::uint8_t from, std::uint8_t to, double share) {
  const double linear = (1 - share) * toLinear(from / 255.0) + share * toLinear(to / 255.0);
  return static_cast<std::uint8_t>(std::lround(255 * toEncoded(linear)));
}

}  // namespace

std::vector<float> figureShares(std::span<const float> values, bool figureIsHigh) {
  std::vector<float> sorted(values.begin(), values.end());
  if (sorted.empty()) return sorted;
  const auto quantile = [&](double share) {
    const auto place =
        sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), place, sorted.end());
    return *place;
  };
  float low = quantile(0.05), high = quantile(0.95);
  const auto isFlat = [&] { return !(high - low > kFlat * std::max(std::abs(low), std::abs(high))); };
  if (isFlat()) {
    // A pattern that covers little so far, such as the seeds of a zebra.
    low = quantile(0);
    high = quantile(1);
  }
  std::vector<float> shares(values.size(), 0);
  if (isFlat()) return shares;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float t = std::clamp((values[i] - low) / (high - low), 0.f, 1.f);
    const float step = t * t * (3 - 2 * t);
    shares[i] = figureIsHigh ? step : 1 - step;
  }
  return shares;
}

std::vector<Rgba8> blendColors(std::span<const float> shares, Rgba8 ground, Rgba8 figure) {
  std::array<Rgba8, 256> blends;
  for (std::size_t step = 0; step < blends.size(); ++step) {
    const double share = static_cast<double>(step) / 255;
    blends[step] = {mix(ground.r, figure.r, share), mix(ground.g, figure.g, share),
                    mix(ground.b, figure.b, share)};
  }
  std::vector<Rgba8> colors(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    colors[i] = blends[static_cast<std::size_t>(std::lround(255 * std::clamp(shares[i], 0.f, 1.f)))];
  }
  return colors;
}

}  // namespace stipple
