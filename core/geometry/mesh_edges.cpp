#include "core/geometry/mesh_edges.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/geometry/site_sets.h"
#include "core/parallel.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 1 << 14;

bool hasArea(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

// visit(low, high, isUpwards) for the sides of a triangle.
template <class Visit>
void forSides(const Triangle& t, const Visit& visit) {
  for (std::size_t c = 0; c < 3; ++c) {
    const Index a = t[c], b = t[(c + 1) % 3];
    visit(std::min(a, b), std::max(a, b), a < b);
  }
}

// Vertices whose triangles are joined through edges at the vertex into more than one set. Corners of
// triangles are the elements: corner c of triangle t is 3 t + c.
std::size_t countNonManifoldVertices(std::span<const Triangle> triangles, const MeshEdges& edges,
                                     Index corners) {
  SiteSets sets(static_cast<Index>(3 * triangles.size()));
  const auto cornerOf = [&](Index triangle, Index vertex) {
    const Triangle& t = triangles[triangle];
    return 3 * triangle + static_cast<Index>(t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2);
  };
  edges.forEach([&](Index low, std::span<const MeshEdges::Use> uses) {
    for (std::size_t u = 1; u < uses.size(); ++u) {
      for (const Index end : {low, uses[0].high})
        sets.join(cornerOf(uses[0].triangle, end), cornerOf(uses[u].triangle, end));
    }
  });
  std::vector<std::uint8_t> roots(corners, 0);
  for (Index t = 0; t < triangles.size(); ++t) {
    if (!hasArea(triangles[t])) continue;
    for (Index c = 0; c < 3; ++c) {
      std::uint8_t& held = roots[triangles[t][c]];
      if (sets.rootOf(3 * t + c) == 3 * t + c && held < 2) ++held;
    }
  }
  return static_cast<std::size_t>(std::ranges::count(roots, 2));
}

}  // namespace

MeshEdges::MeshEdges(std::span<const Triangle> triangles, Index corners) : begins_(corners + std::size_t{1}) {
  const auto forEachSide = [&](const auto& visit) {
    parallelFor(triangles.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (auto t = static_cast<Index>(begin); t < end; ++t) {
        if (hasArea(triangles[t]))
          forSides(triangles[t],
                   [&](Index low, Index high, bool isUpwards) { visit(t, low, high, isUpwards); });
      }
    });
  };
  const auto takeNext = [](std::size_t& count) {
    return std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
  };
  forEachSide([&](Index, Index low, Index, bool) { takeNext(begins_[low + 1]); });
  for (Index low = 0; low < corners; ++low) begins_[low + 1] += begins_[low];
  uses_.resize(begins_.back());
  // In any order first: sorted below.
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  forEachSide([&](Index t, Index low, Index high, bool isUpwards) {
    uses_[takeNext(next[low])] = {high, t, isUpwards};
  });
  parallelFor(corners, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t low = begin; low < end; ++low) {
      std::sort(uses_.begin() + static_cast<std::ptrdiff_t>(begins_[low]),
                uses_.begin() + static_cast<std::ptrdiff_t>(begins_[low + 1]),
                [](const Use& a, const Use& b) {
                  return std::pair(a.high, a.triangle) < std::pair(b.high, b.triangle);
                });
    }
  });
}

std::span<const MeshEdges::Use> MeshEdges::of(Index a, Index b) const {
  const auto found = std::ranges::equal_range(from(std::min(a, b)), std::max(a, b), {}, &Use::high);
  return {found.begin(), found.end()};
}

MeshReport describeMesh(std::span<const Triangle> triangles, Index corners) {
  const MeshEdges edges(triangles, corners);
  MeshReport report;
  SiteSets parts(corners), rims(corners);
  std::vector<std::uint8_t> isUsed(corners, 0), isRim(corners, 0);
  edges.forEach([&](Index low, std::span<const MeshEdges::Use> uses) {
    const Index high = uses[0].high;
    ++report.edges;
    isUsed[low] = isUsed[high] = 1;
    parts.join(low, high);
    report.nonManifoldEdges += uses.size() > 2;
    report.inconsistentEdges += uses.size() == 2 && uses[0].isUpwards == uses[1].isUpwards;
    if (uses.size() != 1) return;
    ++report.boundaryEdges;
    isRim[low] = isRim[high] = 1;
    rims.join(low, high);
  });
  for (Index v = 0; v < corners; ++v) {
    report.vertices += isUsed[v];
    report.components += isUsed[v] && parts.rootOf(v) == v;
    report.boundaryLoops += isRim[v] && rims.rootOf(v) == v;
  }
  const auto faces = std::ranges::count_if(triangles, hasArea);
  report.eulerNumber =
      static_cast<std::int64_t>(report.vertices) - static_cast<std::int64_t>(report.edges) + faces;
  report.nonManifoldVertices = countNonManifoldVertices(triangles, edges, corners);
  return report;
}

}  // namespace stipple
