#include "render/hierarchy/pick.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>

namespace stipple {

namespace {

int levelOf(const Hierarchy& hierarchy, Index node) {
  int level = 0;
  while (node >= hierarchy.levelBegin(level + 1)) ++level;
  return level;
}

struct Subtree {
  int level;
  Index place;  // within the level
};

// Visits subtrees depth first, children in ascending order; visit(node, level) says whether to go on below.
template <class Visit>
void traverse(const Hierarchy& hierarchy, Subtree top, const Visit& visit) {
  std::array<Subtree, 64> stack;  // at most three siblings wait on each of up to 17 levels
  std::size_t waiting = 0;
  stack[waiting++] = top;
  while (waiting > 0) {
    const Subtree at = stack[--waiting];
    if (!visit(hierarchy.levelBegin(at.level) + at.place, at.level) || at.level == 0) continue;
    const Index first = at.place * Hierarchy::kArity;
    const Index end = std::min(first + Hierarchy::kArity, hierarchy.levelSize(at.level - 1));
    for (Index child = end; child-- > first;) stack[waiting++] = {at.level - 1, child};
  }
}

}  // namespace

std::vector<Index> findInBall(const Hierarchy& hierarchy, const Ball& ball) {
  std::vector<Index> slots;
  if (hierarchy.leafCount() == 0) return slots;
  const std::span<const Splat> splats = hierarchy.splats();
  traverse(hierarchy, {hierarchy.levelCount() - 1, 0}, [&](Index node, int level) {
    const float distance = glm::length(splats[node].center() - ball.center);
    if (level > 0) return distance <= ball.radius + hierarchy.boundingRadius(node);
    if (distance <= ball.radius) slots.push_back(node);
    return false;
  });
  return slots;
}

std::vector<Index> findVisibleInBall(const Hierarchy& hierarchy, const Ball& ball, const View& view,
                                     std::span<const float> depth, float tolerance) {
  std::vector<Index> slots = findInBall(hierarchy, ball);
  std::erase_if(slots, [&](Index slot) {
    const Splat& splat = hierarchy.splats()[slot];
    const glm::vec3 p = view.toView(splat.center());
    if (p.z < view.nearDepth) return true;
    const glm::vec2 px = glm::floor(view.toPixels(p));
    if (px.x < 0 || px.y < 0 || px.x >= static_cast<float>(view.width) ||
        px.y >= static_cast<float>(view.height))
      return true;
    const float seen = depth[static_cast<std::size_t>(px.y) * view.width + static_cast<std::size_t>(px.x)];
    return p.z > seen + tolerance + splat.radius;
  });
  return slots;
}

Index nearestLeaf(const Hierarchy& hierarchy, Index node, const glm::vec3& place) {
  const std::span<const Splat> splats = hierarchy.splats();
  const int level = levelOf(hierarchy, node);
  Index best = 0;
  float least = std::numeric_limits<float>::max();
  traverse(hierarchy, {level, node - hierarchy.levelBegin(level)}, [&](Index at, int depth) {
    const float distance = glm::length(splats[at].center() - place);
    if (depth > 0) return distance - hierarchy.boundingRadius(at) < least;
    if (distance < least) {
      least = distance;
      best = at;
    }
    return false;
  });
  return best;
}

}  // namespace stipple
