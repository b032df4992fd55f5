#include "render/appearance/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render/appearance/label_palette.h"
#include "render/appearance/light.h"

namespace stipple {

namespace {

using glm::dvec3;

constexpr Rgba8 kNotANumber{128, 128, 128, 255};

Rgba8 toRgba8(const dvec3& srgb) {
  const dvec3 scaled = glm::round(255.0 * glm::clamp(srgb, 0.0, 1.0));
  return {static_cast<std::uint8_t>(scaled.r), static_cast<std::uint8_t>(scaled.g),
          static_cast<std::uint8_t>(scaled.b), 255};
}

// Every tenth of the map of Smith and van der Walt (2015), sRGB.
constexpr std::array<std::uint32_t, 11> kViridis = {0x440154, 0x482576, 0x414487, 0x35608D,
                                                    0x2A788E, 0x21908C, 0x22A884, 0x43BF71,
                                                    0x7AD151, 0xBBDF27, 0xFDE725};

dvec3 viridisPoint(int i) {
  const std::uint32_t hex = kViridis[std::clamp(i, 0, static_cast<int>(kViridis.size()) - 1)];
  return dvec3((hex >> 16) & 255, (hex >> 8) & 255, hex & 255) / 255.0;
}

// Between two control points: the cubic whose slopes are those of the chords beside them (Catmull and Rom
// 1974).
Rgba8 viridis(double t) {
  const double scaled = t * (kViridis.size() - 1);
  const int i = std::min(static_cast<int>(scaled), static_cast<int>(kViridis.size()) - 2);
  const double x = scaled - i;
  const dvec3 a = viridisPoint(i), b = viridisPoint(i + 1);
  // At the ends the chord beside is the one between the two.
  const dvec3 slopeA = i == 0 ? b - a : 0.5 * (b - viridisPoint(i - 1));
  const dvec3 slopeB = i == static_cast<int>(kViridis.size()) - 2 ? b - a : 0.5 * (viridisPoint(i + 2) - a);
  const double x2 = x * x, x3 = x2 * x;
  return toRgba8((2 * x3 - 3 * x2 + 1) * a + (x3 - 2 * x2 + x) * slopeA + (3 * x2 - 2 * x3) * b +
                 (x3 - x2) * slopeB);
}

// The polynomials of degree 5 that Mikhailov (2019) published with the map.
Rgba8 turbo(double t) {
  constexpr std::array<dvec3, 6> kCoefficients = {{{0.13572138, 0.09140261, 0.10667330},
                                                   {4.61539260, 2.19418839, 12.64194608},
                                                   {-42.66032258, 4.84296658, -60.58204836},
                                                   {132.13108234, -14.18503333, 110.36276771},
                                                   {-152.94239396, 4.27729857, -89.90310912},
                                                   {59.28637943, 2.82956604, 27.34824973}}};
  dvec3 value(0);
  for (auto c = kCoefficients.rbegin(); c != kCoefficients.rend(); ++c) value = value * t + *c;
  return toRgba8(value);
}

// CIELAB of the white of sRGB (D65) to sRGB.
dvec3 srgbFromLab(const dvec3& lab) {
  const double fy = (lab.x + 16) / 116;
  const dvec3 f(fy + lab.y / 500, fy, fy - lab.z / 200);
  const auto inverse = [](double v) { return v > 6.0 / 29 ? v * v * v : 108.0 / 841 * (v - 4.0 / 29); };
  const dvec3 xyz(0.95047 * inverse(f.x), inverse(f.y), 1.08883 * inverse(f.z));
  const dvec3 linear(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z,
                     -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                     0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z);
  const auto encode = [](double l) { return double{srgbFromLinear(static_cast<float>(std::max(l, 0.0)))}; };
  return {encode(linear.r), encode(linear.g), encode(linear.b)};
}

// Moreland (2009), in his polar form of CIELAB: magnitude, saturation angle, hue. From the cool end through
// an unsaturated middle to the warm end; the hue turns a little on the way out of the middle, so that the
// lightness changes evenly.
Rgba8 blueToRed(double t) {
  constexpr double kMagnitude = 80, kSaturation = 1.08, kCoolHue = -1.1, kWarmHue = 0.5, kMiddle = 88;
  const double away = std::abs(2 * t - 1);  // from the middle
  const double magnitude = kMiddle + away * (kMagnitude - kMiddle), saturation = away * kSaturation;
  const double spin = kSaturation * std::sqrt(kMiddle * kMiddle - kMagnitude * kMagnitude) /
                      (kMagnitude * std::sin(kSaturation));
  const double hue = t < 0.5 ? kCoolHue - (1 - away) * spin : kWarmHue + (1 - away) * spin;
  return toRgba8(
      srgbFromLab({magnitude * std::cos(saturation), magnitude * std::sin(saturation) * std::cos(hue),
                   magnitude * std::sin(saturation) * std::sin(hue)}));
}

}  // namespace

std::vector<std::string> colormapNames() {
  return {"viridis", "turbo", "blue-to-red", "gray"};
}

Rgba8 mapColor(Colormap map, double t) {
  if (std::isnan(t)) return kNotANumber;
  t = std::clamp(t, 0.0, 1.0);
  switch (map) {
    case Colormap::kViridis:
      return viridis(t);
    case Colormap::kTurbo:
      return turbo(t);
    case Colormap::kBlueToRed:
      return blueToRed(t);
    case Colormap::kGray:
      break;
  }
  return toRgba8(dvec3(t));
}

Rgba8 labelColor(std::int64_t label) {
  if (label == 0) return kNotANumber;
  const auto& palette = labelPalette();
  const auto period = static_cast<std::int64_t>(palette.size());
  // 1 is the first color; labels below 0 count on backwards.
  return palette[static_cast<std::size_t>(((label - (label > 0 ? 1 : 0)) % period + period) % period)];
}

std::vector<double> legendTicks(double low, double high, int count) {
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high) || count < 1) return {};
  // The step of 1, 2 or 5 times a power of ten that comes nearest to the wanted number of steps. Halves keep
  // the length of the longest ranges finite.
  const double wanted = (high / 2 - low / 2) / count * 2;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0}) {
    if (std::abs(std::log(factor * power / wanted)) < std::abs(std::log(step / wanted)))
      step = factor * power;
  }
  std::vector<double> ticks;
  const double first = std::ceil(low / step), last = std::floor(high / step);
  for (double k = first; k <= last && ticks.size() < 10u * static_cast<std::size_t>(count); ++k) {
    ticks.push_back(std::clamp(k * step, low, high) + 0.0);  // never -0
  }
  return ticks;
}

}  // namespace stipple
