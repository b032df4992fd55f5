#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/appearance/appearance.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// The uniform block of shaders/frame.glsl, member by member in std140 layout.
struct FrameBlock {
  std::array<glm::vec4, 3> viewFromWorld;  // columns
  glm::vec3 eye;
  float focalPx;
  glm::vec2 principalPx, sizePx;
  float nearDepth, depthScale, depthShift;
  std::uint32_t isPerspective;
  float leastCosine, screenRadiusPx, depthBand, normalCosine;
  glm::vec3 keyLight;
  float ambient;
  glm::vec3 selectionColor;
  float selectionShare;
  glm::vec3 brushCenter;
  float brushRadius;
  glm::vec3 brushColor;
  float diffuse;
  glm::vec4 background;
  float leastWeight;
  float edgeStrength;  // of the mean response of the neighbors
  std::uint32_t isLit, isTwoSided, splatMode, isBlended;
  float headLight, ringPx, ringFill;
  float visibleShare, smallDiscPx, leastScreenRadiusPx;
  std::uint32_t isOneOfMany;
  std::array<std::uint32_t, 3> padding;  // blocks end at whole vectors
};
static_assert(sizeof(FrameBlock) == 256);

/// `isBlended`: the surface is read from sums, as after the attribute pass, not from the visible splat alone.
FrameBlock makeFrameBlock(const View& view, const Appearance& appearance, bool isBlended);

}  // namespace stipple
