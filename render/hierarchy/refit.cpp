#include "render/hierarchy/refit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/appearance/light.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 4096;
// Rounding must not let a child out of its parent's sphere.
constexpr float kSlack = 1 + 4e-7f;

// Children summed up, weighted by their areas; normals turned to one side.
struct Sums {
  float area = 0;
  glm::vec3 center{0}, normal{0}, color{0};
  float selected = 0;
  bool isFlipped = false;

  void add(const Splat& child, glm::vec3& n) {
    const float a = std::max(areaOf(child), kLeastArea);
    if (glm::dot(n, normal) < 0) {
      n = -n;
      isFlipped = true;
    }
    area += a;
    center += a * child.center();
    normal += a * n;
    color += a * glm::vec3(linear[child.color.r], linear[child.color.g], linear[child.color.b]);
    selected += a * static_cast<float>(child.color.a);
  }

  static constexpr float kLeastArea = 1e-30f;
  const std::array<float, 256>& linear = linearTable();
};

// The part of Splat::shape that says how a disc of a level overlaps its neighbors; all levels from 3 on are
// alike.
const std::array<std::uint32_t, 4>& ratioBits() {
  static const std::array<std::uint32_t, 4> bits = [] {
    std::array<std::uint32_t, 4> packed{};
    for (int level = 1; level < 4; ++level)
      packed[level] = packShape(glm::vec3(0, 0, 1), 1 / radiusOfArea(level)) & 0xff000000;
    return packed;
  }();
  return bits;
}

// Cosine of the sum of two angles in [0, pi] given by their cosines, -1 from pi on.
float cosineOfSum(float a, float b) {
  if (a <= -b) return -1;
  return a * b - std::sqrt(std::max(0.f, (1 - a * a) * (1 - b * b)));
}

}  // namespace

void aggregate(Hierarchy& hierarchy, Index parent, Index first, Index count) {
  const int level = first < hierarchy.leafCount() ? 1 : first < hierarchy.levelBegin(2) ? 2 : 3;
  const std::span<Splat> splats = hierarchy.editSplats();
  std::array<glm::vec3, Hierarchy::kArity> normals;
  Sums sums;
  for (Index i = 0; i < count; ++i) {
    normals[i] = unpackNormal(splats[first + i].shape);
    sums.add(splats[first + i], normals[i]);
  }
  const float scale = 1 / sums.area;
  const glm::vec3 center = scale * sums.center, color = scale * sums.color;
  const std::uint32_t shape = packNormal(sums.normal) | ratioBits()[level];
  splats[parent] = {center.x,
                    center.y,
                    center.z,
                    radiusOfArea(level) * std::sqrt(sums.area),
                    shape,
                    {encodeSrgb(color.x), encodeSrgb(color.y), encodeSrgb(color.z),
                     static_cast<std::uint8_t>(scale * sums.selected + 0.5f)}};

  Bound bound{0, sums.isFlipped ? -1.f : 1.f};
  const glm::vec3 axis = unpackNormal(shape);
  const bool overLeaves = first < hierarchy.leafCount();
  for (Index i = 0; i < count; ++i) {
    const Index child = first + i;
    bound.radius = std::max(bound.radius,
                            glm::length(splats[child].center() - center) + hierarchy.boundingRadius(child));
    if (bound.cosine <= 0) continue;
    const float turned = std::min(glm::dot(axis, normals[i]), 1.f);
    // A leaf's disc stands for a surface that bends away from it about as its siblings do.
    bound.cosine =
        std::min(bound.cosine, cosineOfSum(turned, overLeaves ? turned : hierarchy.bound(child).cosine));
  }
  bound.radius *= kSlack;
  hierarchy.editBound(parent) = bound;
}

namespace {

// Nodes [begin, end) of a level, counted within it, from the level below.
void aggregateRange(Hierarchy& hierarchy, int level, std::size_t begin, std::size_t end) {
  const Index below = hierarchy.levelBegin(level - 1), size = hierarchy.levelSize(level - 1);
  for (std::size_t i = begin; i < end; ++i) {
    const auto first = static_cast<Index>(i * Hierarchy::kArity);
    aggregate(hierarchy, hierarchy.levelBegin(level) + static_cast<Index>(i), below + first,
              std::min<Index>(Hierarchy::kArity, size - first));
  }
}

// Uploads of a few nodes cost more than copying the gap between them.
constexpr Index kLargestGap = 64;

void appendCoalesced(std::vector<NodeRange>& ranges, Index node) {
  if (!ranges.empty() && node <= ranges.back().end + kLargestGap && node >= ranges.back().begin) {
    ranges.back().end = std::max(ranges.back().end, node + 1);
  } else {
    ranges.push_back({node, node + 1});
  }
}

}  // namespace

void refitLeaves(Hierarchy& hierarchy, std::size_t begin, std::size_t end, int levels) {
  for (int level = 1; level <= levels && level < hierarchy.levelCount(); ++level) {
    begin /= Hierarchy::kArity;
    end = (end + Hierarchy::kArity - 1) / Hierarchy::kArity;
    aggregateRange(hierarchy, level, begin, end);
  }
}

void refitAll(Hierarchy& hierarchy, const Progress* progress, int lowest) {
  for (int level = lowest; level < hierarchy.levelCount(); ++level) {
    parallelFor(
        hierarchy.levelSize(level), kGrain,
        [&](std::size_t begin, std::size_t end) { aggregateRange(hierarchy, level, begin, end); }, progress);
  }
}

std::vector<NodeRange> refit(Hierarchy& hierarchy, std::span<const Index> slots) {
  std::vector<Index> touched(slots.begin(), slots.end());
  if (!std::is_sorted(touched.begin(), touched.end())) std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  std::vector<NodeRange> ranges;
  for (const Index slot : touched) appendCoalesced(ranges, slot);
  for (int level = 1; level < hierarchy.levelCount(); ++level) {
    for (Index& node : touched) node /= Hierarchy::kArity;
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    parallelFor(touched.size(), kGrain / 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) aggregateRange(hierarchy, level, touched[i], touched[i] + 1);
    });
    for (const Index node : touched) appendCoalesced(ranges, hierarchy.levelBegin(level) + node);
  }
  return ranges;
}

}  // namespace stipple
