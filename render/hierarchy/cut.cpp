#include "render/hierarchy/cut.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "render/hierarchy/closedness.h"

namespace stipple {

namespace {

// A node's threshold lies within a factor of 2^(+-1/2) of tau: a 4-ary tree halves sizes from level to level,
// so that thresholds of all nodes together cover one level evenly.
constexpr float kSpread = 0.5f;
// A node changes sides only where its size passes the threshold by a tenth.
constexpr float kHysteresis = 1.1f;
// A disc whose sphere is this many times larger does not fill it: it bridges a gap or joins two sheets.
constexpr float kLoosest = 2.2f;
// Subtrees that are handed to threads.
constexpr Index kRoots = 2048;

// 2^(kSpread t) for t in [-1, 1], by a hash of the node.
float spreadOf(Index node) {
  std::uint32_t h = node * 0x9e3779b1u;
  h ^= h >> 15;
  h *= 0x85ebca77u;
  h ^= h >> 13;
  return std::exp2(kSpread * (static_cast<float>(h >> 8) * (2.f / (1 << 24)) - 1));
}

const std::array<float, 1024>& spreadTable() {
  static const std::array<float, 1024> table = [] {
    std::array<float, 1024> values{};
    for (Index i = 0; i < values.size(); ++i) values[i] = spreadOf(i);
    return values;
  }();
  return table;
}

}  // namespace

// One pass through the tree with one threshold.
class CutSelection {
 public:
  // Backfaces are culled where the options say so, whatever the model.
  CutSelection(const Hierarchy& hierarchy, const View& view, const CutOptions& options, float tau,
               CutMemory* memory)
      : hierarchy_(hierarchy), view_(view), options_(options), tau_(tau) {
    const float halfWidth = 0.5f * static_cast<float>(view.width) / view.focalPx;
    const float halfHeight = 0.5f * static_cast<float>(view.height) / view.focalPx;
    slope_ = {halfWidth, halfHeight};
    scale_ = {1 / std::sqrt(1 + halfWidth * halfWidth), 1 / std::sqrt(1 + halfHeight * halfHeight)};
    if (memory) {
      const std::size_t inner = hierarchy.nodeCount() - hierarchy.leafCount();
      if (memory->opened_.size() != inner) memory->opened_.assign(inner, kUnknown);
      opened_ = memory->opened_.data();
    }
    spread_ = spreadTable().data();
  }

  // Nodes of the cut, in depth-first order; nothing where there would be more than the budget.
  bool select(std::vector<Index>& nodes, const Progress* progress);

 private:
  static constexpr std::uint8_t kUnknown = 2;

  struct Place {
    int level;
    Index node;
  };

  // A subtree that one thread descends, or a node above all of those that is drawn itself.
  struct Root {
    Place place;
    float depth;  // of its nearest place
    bool isDrawn;
  };
  struct Stack {
    std::array<Place, 64> places;  // at most three siblings wait on each of up to 17 levels
    std::size_t size = 0;
  };

  std::vector<Root> findRoots() const;
  // Nodes to draw, depth first; subtrees of the level `lowest` are not looked into.
  void descend(Place top, int lowest, std::vector<Place>& places) const;
  void push(Place parent, Stack& stack) const;
  bool isOutside(const glm::vec3& inView, float radius) const;
  bool facesAway(Index node, const glm::vec3& center, float radius) const;
  bool opens(Place place, const Splat& splat, const glm::vec3& inView) const;

  const Hierarchy& hierarchy_;
  const View& view_;
  const CutOptions& options_;
  float tau_;
  glm::vec2 slope_, scale_;
  std::uint8_t* opened_ = nullptr;
  const float* spread_ = nullptr;
};

bool CutSelection::isOutside(const glm::vec3& p, float radius) const {
  if (p.z + radius < view_.nearDepth) return true;
  if (view_.isPerspective()) {
    return (std::abs(p.x) - slope_.x * p.z) * scale_.x > radius ||
           (std::abs(p.y) - slope_.y * p.z) * scale_.y > radius;
  }
  return std::abs(p.x) - slope_.x > radius || std::abs(p.y) - slope_.y > radius;
}

// All normals within the cone point away from an eye that is outside of the sphere, wherever in it the
// surface is.
bool CutSelection::facesAway(Index node, const glm::vec3& center, float radius) const {
  if (hierarchy_.levelCount() < 2) return false;
  // A leaf's own cone is at most as wide as that of its parent.
  const bool isLeaf = node < hierarchy_.leafCount();
  const float cosine =
      hierarchy_.bound(isLeaf ? hierarchy_.levelBegin(1) + node / Hierarchy::kArity : node).cosine;
  if (cosine <= 0) return false;
  const glm::vec3 normal = unpackNormal(hierarchy_.splats()[node].shape);
  const float sine = std::sqrt(std::max(0.f, 1 - cosine * cosine));
  if (!view_.isPerspective()) {
    const glm::vec3 forward(view_.viewFromWorld[0].z, view_.viewFromWorld[1].z, view_.viewFromWorld[2].z);
    return glm::dot(normal, forward) > sine;
  }
  const glm::vec3 towards = view_.eye - center;
  const float along = glm::dot(normal, towards) + radius, distance = glm::length(towards) - radius;
  return distance > 0 && along < 0 && -along > distance * sine + 2 * radius * sine;
}

bool CutSelection::opens(Place place, const Splat& splat, const glm::vec3& p) const {
  if (place.level == 0) return false;
  const float bound = hierarchy_.bound(place.node).radius;
  const float radius = std::max(splat.radius, bound / kLoosest);
  // Spheres that reach behind the eye have a finite size too, so that any budget can be kept.
  const float distance = view_.isPerspective() ? std::max(p.z - bound, 1e-4f * bound) : 1;
  const float size = 2 * radius * view_.focalPx;
  float threshold = tau_ * spread_[place.node & 1023] * distance;
  if (!opened_) return size > threshold;
  std::uint8_t& opened = opened_[place.node - hierarchy_.leafCount()];
  if (opened == 1) threshold *= 1 / kHysteresis;
  if (opened == 0) threshold *= kHysteresis;
  opened = size > threshold;
  return opened == 1;
}

// Children in ascending order on top of the stack.
void CutSelection::push(Place parent, Stack& stack) const {
  const Index below = hierarchy_.levelBegin(parent.level - 1);
  const Index first = (parent.node - hierarchy_.levelBegin(parent.level)) * Hierarchy::kArity;
  const Index end = std::min(first + Hierarchy::kArity, hierarchy_.levelSize(parent.level - 1));
  for (Index child = end; child-- > first;) stack.places[stack.size++] = {parent.level - 1, below + child};
}

void CutSelection::descend(Place top, int lowest, std::vector<Place>& places) const {
  const std::span<const Splat> splats = hierarchy_.splats();
  Stack stack;
  stack.places[stack.size++] = top;
  while (stack.size > 0) {
    const Place place = stack.places[--stack.size];
    const Splat& splat = splats[place.node];
    const glm::vec3 p = view_.toView(splat.center());
    const float bound = hierarchy_.boundingRadius(place.node);
    if (options_.cullFrustum && isOutside(p, bound)) continue;
    if (options_.cullBackfaces && facesAway(place.node, splat.center(), bound)) continue;
    if (place.level > lowest && opens(place, splat, p)) {
      push(place, stack);
    } else {
      places.push_back(place);
    }
  }
}

std::vector<CutSelection::Root> CutSelection::findRoots() const {
  int level = hierarchy_.levelCount() - 1;
  while (level > 0 && hierarchy_.levelSize(level) < kRoots) --level;
  const Place top{hierarchy_.levelCount() - 1, hierarchy_.levelBegin(hierarchy_.levelCount() - 1)};
  std::vector<Place> places;
  descend(top, level, places);
  std::vector<Root> roots;
  for (const Place& place : places) {
    const float depth = view_.toView(hierarchy_.splats()[place.node].center()).z;
    roots.push_back({place, depth - hierarchy_.boundingRadius(place.node), place.level > level});
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [](const Root& a, const Root& b) { return a.depth < b.depth; });
  return roots;
}

bool CutSelection::select(std::vector<Index>& nodes, const Progress* progress) {
  const std::vector<Root> roots = findRoots();
  std::vector<std::vector<Place>> parts(roots.size());
  std::atomic<std::size_t> count{0};
  std::atomic<bool> isTooMuch{false};
  parallelFor(
      roots.size(), 8,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t root = begin; root < end && !isTooMuch; ++root) {
          if (roots[root].isDrawn) {
            parts[root] = {roots[root].place};
          } else {
            descend(roots[root].place, 0, parts[root]);
          }
          if ((count += parts[root].size()) > options_.budget) isTooMuch = true;
        }
      },
      progress);
  if (isTooMuch) return false;
  std::vector<std::size_t> begins(parts.size());
  std::size_t sum = 0;
  for (std::size_t root = 0; root < parts.size(); ++root)
    begins[root] = std::exchange(sum, sum + parts[root].size());
  nodes.resize(sum);
  parallelFor(
      parts.size(), 64,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t root = begin; root < end; ++root)
          std::ranges::transform(parts[root], nodes.data() + begins[root], &Place::node);
      },
      progress);
  return true;
}

float tauOfMean(float tau, std::size_t nodes) {
  constexpr float kNodes = 2e6f, kFinest = 2;
  // The number of nodes goes with 1 / tau^2.
  return std::clamp(tau * std::sqrt(static_cast<float>(nodes) / kNodes), kFinest, CutOptions().tau);
}

Cut selectCut(const Hierarchy& hierarchy, const View& view, const CutOptions& wanted, CutMemory* memory,
              const Progress* progress) {
  Cut cut{.nodes = {}, .tau = wanted.tau, .isComplete = true};
  if (hierarchy.leafCount() == 0) return cut;
  CutOptions options = wanted;
  // Who looks from inside sees the backs.
  options.cullBackfaces &= hierarchy.isClosedAndOriented && !isInside(hierarchy, view.eye);
  constexpr float kCoarser = 1.3f;
  while (!CutSelection(hierarchy, view, options, cut.tau, memory).select(cut.nodes, progress)) {
    cut.tau *= kCoarser;
    cut.isComplete = false;
  }
  return cut;
}

}  // namespace stipple
