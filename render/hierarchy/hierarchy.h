#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/points/attribute.h"
#include "render/hierarchy/raw_vector.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// What is drawn for a node: a disc of the surface. The layout is that of the buffers on the GPU.
struct Splat {
  float x = 0, y = 0, z = 0;  ///< center, world
  float radius = 0;           ///< of the disc; the kernel falls to zero there
  std::uint32_t shape = 0;    ///< normal and share of the disc that counts as area, see packShape
  Rgba8 color;                ///< sRGB; alpha holds how much is selected, 0 to 255

  glm::vec3 center() const { return {x, y, z}; }
};
static_assert(sizeof(Splat) == 24);

/// A unit vector on the octahedron (Meyer et al. 2010), bits 0 to 11 and 12 to 23: a / 2047.5 - 1; and in
/// bits 24 to 31 the ratio of sqrt(area) to the radius as 2^(code / 32 - 6). Discs overlap: their areas are
/// those of the surface.
std::uint32_t packShape(const glm::vec3& normal, float areaRatio);
std::uint32_t packNormal(const glm::vec3& normal);
inline glm::vec3 unpackNormal(std::uint32_t shape) {
  constexpr float kStep = 2.f / 4095;
  const float x = static_cast<float>(shape & 0xfff) * kStep - 1;
  const float y = static_cast<float>(shape >> 12 & 0xfff) * kStep - 1;
  const float z = 1 - std::abs(x) - std::abs(y), fold = std::max(-z, 0.f);
  const glm::vec3 n(x - std::copysign(fold, x), y - std::copysign(fold, y), z);
  return n * (1 / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z));
}
float unpackAreaRatio(std::uint32_t shape);

/// Area of the surface that a splat stands for, length^2.
inline float areaOf(const Splat& splat) {
  const float side = splat.radius * unpackAreaRatio(splat.shape);
  return side * side;
}

/// Radius of the disc of an inner node of a level over the root of its area. A square is covered from .71 on
/// and blends well at 1; blocks of a few random points are less regular. Powers of two that packShape holds
/// exactly.
inline float radiusOfArea(int level) {
  return level == 1 ? 1.2418578f : level == 2 ? 1.0905077f : 1.0442738f;  // 2^(10/32), 2^(4/32), 2^(2/32)
}

/// What the cut needs of an inner node, about the center of its splat.
struct Bound {
  float radius = 0;   ///< of the sphere about all descendants' discs
  float cosine = -1;  ///< of the half angle of the cone about all descendants' normals, wider over leaves by
                      ///< as much as these bend; <= 0: no cone
};

/// Splats of all levels in one array: level 0 are the leaves, one a point, in an order that makes every
/// aligned block of 4^k of them a compact subtree; the parent of node i of a level is node i / 4 of the next,
/// up to a single root. A node's center, color (in linear light) and normal are the area-weighted means of
/// its children's; its area is their sum, its radius radiusOfArea times the root of that.
class Hierarchy {
 public:
  static constexpr int kArity = 4;

  Hierarchy() = default;
  /// Room for `leaves` leaves and all nodes above them, not filled in.
  explicit Hierarchy(Index leaves);

  Index leafCount() const { return leaves_; }
  Index nodeCount() const { return levelBegins_.empty() ? 0 : levelBegins_.back(); }
  int levelCount() const { return static_cast<int>(levelBegins_.size()) - 1; }
  /// Nodes of a level are [levelBegin(level), levelBegin(level + 1)).
  Index levelBegin(int level) const { return levelBegins_[level]; }
  Index levelSize(int level) const { return levelBegins_[level + 1] - levelBegins_[level]; }

  std::span<const Splat> splats() const { return splats_; }
  std::span<Splat> editSplats() { return splats_; }
  /// Of an inner node, by its index among all nodes.
  const Bound& bound(Index node) const { return bounds_[node - leaves_]; }
  Bound& editBound(Index node) { return bounds_[node - leaves_]; }
  float boundingRadius(Index node) const {
    return node < leaves_ ? splats_[node].radius : bounds_[node - leaves_].radius;
  }

  /// Slots are leaves: point of slot, slot of point.
  RawVector<Index> pointOfSlot, slotOfPoint;
  /// The surface is closed and its normals point outwards: what faces away may be left out. Set by those who
  /// asked closedness.h; building leaves it false, moved or removed points ask anew.
  bool isClosedAndOriented = false;

  std::size_t memoryBytes() const;

 private:
  Index leaves_ = 0;
  std::vector<Index> levelBegins_;
  RawVector<Splat> splats_;
  RawVector<Bound> bounds_;
};

}  // namespace stipple
