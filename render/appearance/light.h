#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace stipple {

/// The light model that every back end and the shader resolve share. Directions are in view space (x right, y
/// down, z forward), intensities linear.
namespace light {
inline constexpr glm::vec3 kKey{-0.325357f, -0.542261f,
                                -0.774659f};  ///< over the viewer's left shoulder, unit
/// Shares of light from everywhere, from the key, and from the viewer.
inline constexpr float kAmbient = 0.16f, kDiffuse = 0.62f, kHead = 0.22f;

/// Factor of the albedo for a unit normal; two-sided light turns normals towards the viewer before.
inline float shade(const glm::vec3& normal) {
  return kAmbient + kDiffuse * glm::max(glm::dot(normal, kKey), 0.f) + kHead * glm::max(-normal.z, 0.f);
}
}  // namespace light

inline float linearFromSrgb(float s) {
  return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}
inline float srgbFromLinear(float l) {
  return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1 / 2.4f) - 0.055f;
}

/// Linear value of each 8-bit sRGB value.
const std::array<float, 256>& linearTable();
/// 8-bit sRGB value of every linear one in steps of 1/65535: the nearest but for a twentieth of a step.
inline constexpr int kEncodeSteps = 65536;
const std::array<std::uint8_t, kEncodeSteps>& encodeTable();
/// 8-bit sRGB value of a linear one, clamped; NaN is 0.
inline std::uint8_t encodeSrgb(float linear) {
  const float scaled = linear * (kEncodeSteps - 1) + 0.5f;
  if (!(scaled > 0)) return 0;
  return scaled >= kEncodeSteps ? 255 : encodeTable()[static_cast<int>(scaled)];
}

}  // namespace stipple
