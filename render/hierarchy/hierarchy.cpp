#include "render/hierarchy/hierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stipple {

namespace {

constexpr float kSteps = 4095;

std::uint32_t quantize(float t) {
  return static_cast<std::uint32_t>(std::clamp((t + 1) * 0.5f * kSteps, 0.f, kSteps) + 0.5f);
}

float signOf(float t) {
  return t >= 0 ? 1.f : -1.f;
}

const std::array<float, 256>& ratioTable() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (int i = 0; i < 256; ++i) values[i] = std::exp2(static_cast<float>(i) / 32 - 6);
    return values;
  }();
  return table;
}

}  // namespace

std::uint32_t packNormal(const glm::vec3& normal) {
  const float sum = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  const bool isVector = sum > 0 && std::isfinite(sum);
  const glm::vec3 n = isVector ? normal / sum : glm::vec3(0, 0, 1);
  glm::vec2 p(n.x, n.y);
  if (n.z < 0) p = {(1 - std::abs(n.y)) * signOf(n.x), (1 - std::abs(n.x)) * signOf(n.y)};
  return quantize(p.x) | quantize(p.y) << 12;
}

std::uint32_t packShape(const glm::vec3& normal, float areaRatio) {
  const float code = areaRatio > 0 ? std::clamp(std::round(32 * (std::log2(areaRatio) + 6)), 0.f, 255.f) : 0;
  return packNormal(normal) | static_cast<std::uint32_t>(code) << 24;
}

float unpackAreaRatio(std::uint32_t shape) {
  return ratioTable()[shape >> 24];
}

Hierarchy::Hierarchy(Index leaves) : leaves_(leaves), levelBegins_{0} {
  std::size_t end = leaves;
  for (std::size_t size = leaves; size > 0; size = size == 1 ? 0 : (size + kArity - 1) / kArity) {
    if (size != leaves) end += size;
    levelBegins_.push_back(static_cast<Index>(end));
  }
  splats_.resize(nodeCount());
  bounds_.resize(nodeCount() - leaves);
}

std::size_t Hierarchy::memoryBytes() const {
  return nodeCount() * sizeof(Splat) + (nodeCount() - leaves_) * sizeof(Bound) +
         (pointOfSlot.capacity() + slotOfPoint.capacity()) * sizeof(Index);
}

}  // namespace stipple
