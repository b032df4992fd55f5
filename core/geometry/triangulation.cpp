#include "core/geometry/triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/geometry/consensus_patch.h"
#include "core/geometry/mesh_edges.h"

namespace stipple {

namespace {

constexpr Index kNone = std::numeric_limits<Index>::max();

// Boundary edges, and how the rims of holes go through their ends: at a site of two chains of triangles each
// gap between them lies between the end of one and the start of the other.
class Rims {
 public:
  Rims(std::span<const Triangle> triangles, const MeshEdges& edges);

  /// Closed walks of at most `longest` edges that come to no site twice.
  std::vector<std::vector<Index>> findLoops(std::size_t longest) const;

 private:
  struct End {
    Index other, triangle;
    bool leaves;  // the triangle runs from the site to the other end
  };
  Index farEndOfChain(std::span<const Triangle> triangles, const MeshEdges& edges, Index site,
                      const End& start) const;
  void pair(Index site, Index a, Index b) {
    next_[{a, site}] = b;
    next_[{b, site}] = a;
  }

  std::map<std::pair<Index, Index>, Index> next_;  // (from, here): where the rim goes on
};

Rims::Rims(std::span<const Triangle> triangles, const MeshEdges& edges) {
  std::map<Index, std::vector<End>> ends;
  edges.forEach([&](Index low, std::span<const MeshEdges::Use> uses) {
    if (uses.size() != 1) return;
    const auto& [high, triangle, isUpwards] = uses[0];
    ends[low].push_back({high, triangle, isUpwards});
    ends[high].push_back({low, triangle, !isUpwards});
  });
  for (const auto& [site, here] : ends) {
    if (here.size() == 2) pair(site, here[0].other, here[1].other);
    if (here.size() != 4 || std::ranges::count(here, true, &End::leaves) != 2) continue;
    for (const End& start : here) {
      if (!start.leaves) continue;
      const Index own = farEndOfChain(triangles, edges, site, start);
      for (const End& end : here) {
        if (!end.leaves && end.other != own) pair(site, start.other, end.other);
      }
    }
  }
}

// Round the site from triangle to triangle, to the other boundary edge.
Index Rims::farEndOfChain(std::span<const Triangle> triangles, const MeshEdges& edges, Index site,
                          const End& start) const {
  Index triangle = start.triangle, spoke = start.other;
  for (std::size_t turns = 0; turns < triangles.size(); ++turns) {
    const Triangle& t = triangles[triangle];
    spoke = t[0] + t[1] + t[2] - site - spoke;
    const auto uses = edges.of(site, spoke);
    if (uses.size() != 2) break;
    triangle = uses[0].triangle == triangle ? uses[1].triangle : uses[0].triangle;
  }
  return spoke;
}

std::vector<std::vector<Index>> Rims::findLoops(std::size_t longest) const {
  std::vector<std::vector<Index>> loops;
  std::set<std::pair<Index, Index>> walked;
  for (const auto& [begin, to] : next_) {
    if (walked.contains(begin)) continue;
    std::vector<Index> loop;
    std::pair<Index, Index> at = begin;
    bool isClosed = false;
    while (!isClosed && next_.contains(at) && walked.insert(at).second) {
      loop.push_back(at.second);
      walked.insert({next_.at(at), at.second});  // the same way back
      at = {at.second, next_.at(at)};
      isClosed = at == begin;
    }
    std::vector<Index> sorted = loop;
    std::ranges::sort(sorted);
    const bool isSimple = std::ranges::adjacent_find(sorted) == sorted.end();
    if (isClosed && isSimple && loop.size() >= 3 && loop.size() <= longest) loops.push_back(std::move(loop));
  }
  return loops;
}

// Returns whether any was closed.
bool closeHoles(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                std::size_t longest, std::vector<Triangle>& triangles) {
  const auto sites = static_cast<Index>(positions.size());
  const auto loops = Rims(triangles, MeshEdges(triangles, sites)).findLoops(longest);
  std::map<Index, std::vector<Triangle>> at;
  for (const auto& loop : loops) {
    for (const Index site : loop) at[site];
  }
  const auto note = [&](const Triangle& t) {
    for (const Index corner : t) {
      if (const auto found = at.find(corner); found != at.end()) found->second.push_back(t);
    }
  };
  if (loops.empty()) return false;
  std::ranges::for_each(triangles, note);
  for (const auto& loop : loops) {
    std::vector<Triangle> around;
    for (const Index site : loop) around.insert(around.end(), at[site].begin(), at[site].end());
    std::ranges::sort(around);
    around.erase(std::unique(around.begin(), around.end()), around.end());
    const std::vector<Triangle> added = closeLoop(positions, normals, loop, around);
    triangles.insert(triangles.end(), added.begin(), added.end());
    std::ranges::for_each(added, note);
  }
  return true;
}

void addDisputed(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                 const Fans& fans, const Progress* progress, std::vector<Triangle>& triangles) {
  const DisputedPatches disputed = findDisputed(fans, progress);
  std::vector<std::vector<Triangle>> accepted(disputed.size());
  parallelFor(
      accepted.size(), 16,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
          accepted[p] = resolvePatch(positions, normals, fans, disputed.of(p)).triangles;
      },
      progress);
  for (const auto& patch : accepted) triangles.insert(triangles.end(), patch.begin(), patch.end());
}

// For each side of each triangle the other triangle there, and whether one of both has to be turned.
struct Beside {
  Index triangle = kNone;
  bool isReversed = false;
};

std::vector<std::array<Beside, 3>> findNeighbors(std::span<const Triangle> triangles, Index sites) {
  std::vector<std::array<Beside, 3>> beside(triangles.size());
  const auto sideOf = [&](Index triangle, Index low, Index high) {
    const Triangle& t = triangles[triangle];
    for (std::size_t c = 0; c < 2; ++c) {
      const Index a = t[c], b = t[c + 1];
      if (std::min(a, b) == low && std::max(a, b) == high) return c;
    }
    return std::size_t{2};
  };
  MeshEdges(triangles, sites).forEach([&](Index low, std::span<const MeshEdges::Use> uses) {
    if (uses.size() != 2) return;
    const bool isReversed = uses[0].isUpwards == uses[1].isUpwards;
    for (std::size_t u = 0; u < 2; ++u)
      beside[uses[u].triangle][sideOf(uses[u].triangle, low, uses[u].high)] = {uses[1 - u].triangle,
                                                                               isReversed};
  });
  return beside;
}

// Twice the area of a triangle times the cosine with the mean normal of its corners.
double areaAlong(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                 const Triangle& t) {
  const Eigen::Vector3d a = positions[t[0]].cast<double>(), b = positions[t[1]].cast<double>(),
                        c = positions[t[2]].cast<double>();
  return (b - a).cross(c - a).dot((normals[t[0]] + normals[t[1]] + normals[t[2]]).cast<double>());
}

}  // namespace

void windAlong(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
               std::span<Triangle> triangles) {
  const auto beside = findNeighbors(triangles, static_cast<Index>(positions.size()));
  enum : std::uint8_t { kUnknown, kAsIs, kTurned };
  std::vector<std::uint8_t> sense(triangles.size(), kUnknown);
  std::vector<Index> part;
  for (Index start = 0; start < triangles.size(); ++start) {
    if (sense[start] != kUnknown) continue;
    part = {start};
    sense[start] = kAsIs;
    double along = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const bool isTurned = sense[part[i]] == kTurned;
      along += (isTurned ? -1 : 1) * areaAlong(positions, normals, triangles[part[i]]);
      for (const Beside& other : beside[part[i]]) {
        if (other.triangle == kNone || sense[other.triangle] != kUnknown) continue;
        sense[other.triangle] = isTurned != other.isReversed ? kTurned : kAsIs;
        part.push_back(other.triangle);
      }
    }
    const std::uint8_t turned = along < 0 ? kAsIs : kTurned;
    for (const Index t : part) {
      if (sense[t] == turned) std::swap(triangles[t][1], triangles[t][2]);
    }
  }
}

std::vector<Triangle> triangulateFans(std::span<const Eigen::Vector3f> positions,
                                      std::span<const Eigen::Vector3f> normals, const Fans& fans,
                                      const TriangulationOptions& options, const Progress* progress) {
  std::vector<Triangle> triangles = findSettled(fans, progress);
  if (options.votes) addDisputed(positions, normals, fans, progress, triangles);
  if (progress) progress->throwIfCancelled();
  windAlong(positions, normals, triangles);
  if (options.longestHole < 3) return triangles;
  if (progress) progress->throwIfCancelled();
  const auto longest = static_cast<std::size_t>(options.longestHole);
  if (closeHoles(positions, normals, longest, triangles)) windAlong(positions, normals, triangles);
  return triangles;
}

}  // namespace stipple
