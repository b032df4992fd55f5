#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/hierarchy/build.h"
#include "render/hierarchy/cut.h"
#include "render/hierarchy/refit.h"
#include "tests/support/shapes.h"

/// Surfaces as splats, with a checker of two colors.
namespace stipple::scenes {

struct Surface {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<float> radii;
  std::vector<Rgba8> colors;
};

inline Rgba8 checker(const Eigen::Vector3f& p, float cell) {
  const auto side = [cell](float x) { return static_cast<int>(std::floor(x / cell)); };
  return (side(p.x()) + side(p.y()) + side(p.z())) % 2 == 0 ? Rgba8{214, 90, 60, 0} : Rgba8{70, 120, 190, 0};
}

/// Discs of random points leave nothing bare at 1.9 times the side of the area of each.
inline void finish(Surface& surface, float area) {
  const auto count = static_cast<float>(surface.positions.size());
  surface.radii.assign(surface.positions.size(), 1.9f * std::sqrt(area / count));
  for (const Eigen::Vector3f& p : surface.positions) surface.colors.push_back(checker(p, 0.25f));
}

/// The unit sphere.
inline Surface sphere(std::size_t count) {
  Surface surface;
  surface.positions = shapes::randomSphere(count);
  surface.normals = surface.positions;
  finish(surface, 4 * std::numbers::pi_v<float>);
  return surface;
}

/// Radii 1 and .4 about the z axis.
inline Surface torus(std::size_t count) {
  Surface surface;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> turn(0, 2 * std::numbers::pi_v<float>), unit(0, 1);
  while (surface.positions.size() < count) {
    const float u = turn(random), v = turn(random), ring = 1 + 0.4f * std::cos(v);
    if (unit(random) * 1.4f > ring) continue;  // uniform in area
    surface.positions.emplace_back(ring * std::cos(u), ring * std::sin(u), 0.4f * std::sin(v));
    surface.normals.emplace_back(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
  }
  finish(surface, 4 * std::numbers::pi_v<float> * std::numbers::pi_v<float> * 0.4f);
  return surface;
}

/// The square [-1, 1] x [-1, 1] in z = 0.
inline Surface square(std::size_t count) {
  Surface surface;
  for (const Eigen::Vector3f& p : shapes::randomSquare(count)) {
    surface.positions.emplace_back(2 * p.x() - 1, 2 * p.y() - 1, 0.f);
  }
  surface.normals.assign(count, Eigen::Vector3f::UnitZ());
  finish(surface, 4);
  return surface;
}

inline Hierarchy hierarchyOf(const Surface& surface) {
  return buildHierarchy({.positions = surface.positions,
                         .radii = surface.radii,
                         .areas = {},
                         .normals = surface.normals,
                         .colors = surface.colors},
                        LeafOrder::kKd);
}

inline std::vector<NodeRange> allNodes(const Hierarchy& hierarchy) {
  return {{0, hierarchy.nodeCount()}};
}

inline std::vector<Index> allLeaves(const Hierarchy& hierarchy) {
  std::vector<Index> leaves(hierarchy.leafCount());
  for (Index i = 0; i < leaves.size(); ++i) leaves[i] = i;
  return leaves;
}

}  // namespace stipple::scenes
