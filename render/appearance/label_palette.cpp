#include "render/appearance/label_palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "render/appearance/light.h"

namespace stipple {

namespace {

constexpr std::size_t kColors = 256;

glm::vec3 oklabFromSrgb(const Rgba8& color) {
  const auto& linear = linearTable();
  const float r = linear[color.r], g = linear[color.g], b = linear[color.b];
  const float l = std::cbrt(0.4122214708f * r + 0.5363325363f * g + 0.0514459929f * b);
  const float m = std::cbrt(0.2119034982f * r + 0.6806995451f * g + 0.1073969566f * b);
  const float s = std::cbrt(0.0883024619f * r + 0.2817188376f * g + 0.6299787005f * b);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

// Differences of lightness count less: light and shadow change it, hue and chroma stay.
constexpr float kLightnessWeight = 0.7f;
glm::vec3 weighted(glm::vec3 lab) {
  return {kLightnessWeight * lab.x, lab.y, lab.z};
}

struct Candidate {
  Rgba8 color;
  glm::vec3 lab;                                           // weighted
  float nearest = std::numeric_limits<float>::infinity();  // squared distance to what is chosen
};

// A grid in sRGB without what is dark, glaring or gray: light and shadow must show on every color.
std::vector<Candidate> makeCandidates() {
  constexpr int kStep = 15;
  constexpr float kDarkest = 0.48f, kLightest = 0.9f, kLeastChroma = 0.07f, kMostChroma = 0.22f;
  std::vector<Candidate> candidates;
  for (int r = 0; r < 256; r += kStep) {
    for (int g = 0; g < 256; g += kStep) {
      for (int b = 0; b < 256; b += kStep) {
        const Rgba8 color{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                          static_cast<std::uint8_t>(b), 255};
        const glm::vec3 lab = oklabFromSrgb(color);
        const float chroma = std::hypot(lab.y, lab.z);
        if (lab.x < kDarkest || lab.x > kLightest || chroma < kLeastChroma || chroma > kMostChroma) continue;
        candidates.push_back({color, weighted(lab)});
      }
    }
  }
  return candidates;
}

std::array<Rgba8, kColors> makePalette() {
  std::vector<Candidate> candidates = makeCandidates();
  const auto choose = [&](const Rgba8& color) {
    const glm::vec3 lab = weighted(oklabFromSrgb(color));
    for (Candidate& c : candidates) c.nearest = std::min(c.nearest, glm::dot(c.lab - lab, c.lab - lab));
  };
  std::array<Rgba8, kColors> palette{};
  palette[0] = {64, 132, 214, 255};  // a calm blue to begin with
  choose({128, 128, 128, 255});
  choose(palette[0]);
  for (std::size_t i = 1; i < kColors; ++i) {
    palette[i] = std::ranges::max_element(candidates, {}, &Candidate::nearest)->color;
    choose(palette[i]);
  }
  return palette;
}

}  // namespace

std::span<const Rgba8> labelPalette() {
  static const std::array<Rgba8, kColors> palette = makePalette();
  return palette;
}

}  // namespace stipple
