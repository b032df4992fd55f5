#pragma once

#include <algorithm>

#include "render/hierarchy/build.h"
#include "tests/support/ray_scenes.h"

namespace stipple {

/// Leaves with the colors and normals of the samples. Radii and areas are estimated from blocks of leaves.
inline LeafAttributes leavesOf(const scenes::SurfaceSamples& samples) {
  return {.positions = samples.positions,
          .radii = {},
          .areas = {},
          .normals = samples.normals,
          .colors = samples.colors};
}

inline Hierarchy sampledHierarchy(const scenes::Scene& scene, Index count, std::uint64_t seed = 1,
                                  LeafOrder order = LeafOrder::kKd) {
  const scenes::SurfaceSamples samples = scene.sample(count, seed);
  return buildHierarchy(leavesOf(samples), order);
}

/// Same bits of all splats, bounds and orders.
inline bool sameNodes(const Hierarchy& a, const Hierarchy& b) {
  const auto sameSplat = [](const Splat& s, const Splat& t) {
    return s.center() == t.center() && s.radius == t.radius && s.shape == t.shape && s.color == t.color;
  };
  if (a.leafCount() != b.leafCount() || a.pointOfSlot != b.pointOfSlot || a.slotOfPoint != b.slotOfPoint)
    return false;
  for (Index node = a.leafCount(); node < a.nodeCount(); ++node) {
    if (a.bound(node).radius != b.bound(node).radius || a.bound(node).cosine != b.bound(node).cosine)
      return false;
  }
  return std::ranges::equal(a.splats(), b.splats(), sameSplat);
}

}  // namespace stipple
