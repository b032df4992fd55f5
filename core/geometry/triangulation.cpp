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

constexpr std::size_t kGrain = 1 << 13;
constexpr Index kNone = std::numeric_limits<Index>::max();

// Boundary edges, and how the rims of holes go through their ends: at a site of two chains of triangles each
// gap between them lies between the end of one and the start of the other.
class Rims {
 public:
  explicit Rims(const MeshEdges& edges);

  /// Some sites have two chains of triangles.
  bool hasBowTies() const { return hasBowTies_; }
  /// Triangles wind consistently.
  void joinBowTies(std::span<const Triangle> triangles, const MeshEdges& edges);
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

  std::map<Index, std::vector<End>> ends_;
  std::map<std::pair<Index, Index>, Index> next_;  // (from, here): where the rim goes on
  bool hasBowTies_ = false;
};

Rims::Rims(const MeshEdges& edges) {
  edges.forEach([&](Index low, std::span<const MeshEdges::Use> uses) {
    if (uses.size() != 1) return;
    const auto& [high, triangle, isUpwards] = uses[0];
    ends_[low].push_back({high, triangle, isUpwards});
    ends_[high].push_back({low, triangle, !isUpwards});
  });
  for (const auto& [site, ends] : ends_) {
    if (ends.size() == 2) pair(site, ends[0].other, ends[1].other);
    hasBowTies_ |= ends.size() == 4;
  }
}

void Rims::joinBowTies(std::span<const Triangle> triangles, const MeshEdges& edges) {
  for (const auto& [site, ends] : ends_) {
    if (ends.size() != 4 || std::ranges::count(ends, true, &End::leaves) != 2) continue;
    for (const End& start : ends) {
      if (!start.leaves) continue;
      const Index own = farEndOfChain(triangles, edges, site, start);
      for (const End& end : ends) {
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

std::vector<std::vector<Index>> findLoops(std::span<const Eigen::Vector3f> positions, std::size_t longest,
                                          std::span<Triangle> triangles) {
  const auto sites = static_cast<Index>(positions.size());
  Rims rims{MeshEdges(triangles, sites)};
  if (rims.hasBowTies()) {
    windTriangles(positions, {}, triangles);
    const MeshEdges edges(triangles, sites);
    rims = Rims(edges);
    rims.joinBowTies(triangles, edges);
  }
  return rims.findLoops(longest);
}

void closeHoles(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                std::size_t longest, std::vector<Triangle>& triangles) {
  const auto loops = findLoops(positions, longest, triangles);
  std::map<Index, std::vector<Triangle>> at;
  for (const auto& loop : loops) {
    for (const Index site : loop) at[site];
  }
  const auto note = [&](const Triangle& t) {
    for (const Index corner : t) {
      if (const auto found = at.find(corner); found != at.end()) found->second.push_back(t);
    }
  };
  if (loops.empty()) return;
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
}

void addDisputed(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                 const Fans& fans, const DisputedPatches& disputed, const Progress* progress,
                 std::vector<Triangle>& triangles) {
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
  const MeshEdges edges(triangles, sites);
  const auto note = [&](Index low, std::span<const MeshEdges::Use> uses) {
    if (uses.size() != 2) return;
    const bool isReversed = uses[0].isUpwards == uses[1].isUpwards;
    for (std::size_t u = 0; u < 2; ++u) {
      const Index here = uses[u].triangle, there = uses[1 - u].triangle;
      beside[here][sideOf(here, low, uses[u].high)] = {there, isReversed};
    }
  };
  parallelFor(sites, kGrain, [&](std::size_t begin, std::size_t end) {
    for (auto low = static_cast<Index>(begin); low < end; ++low) edges.forEachFrom(low, note);
  });
  return beside;
}

// The sense of the triangles of one connected part; some may have to be turned to agree with the first.
class Part {
 public:
  Part(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> along)
      : positions_(positions), along_(along) {}

  void add(const Triangle& t, bool isTurned) {
    const Eigen::Vector3d a = at(t[0]), b = at(t[1]), c = at(t[2]);
    const Eigen::Vector3d normal = (isTurned ? -1 : 1) * (b - a).cross(c - a);
    area_ += normal.norm();
    if (!along_.empty())
      agreed_ += normal.dot((along_[t[0]] + along_[t[1]] + along_[t[2]]).cast<double>().stableNormalized());
    for (const Index corner : t) {
      if (positions_[corner].z() < top_ || (positions_[corner].z() == top_ && corner > topmost_)) continue;
      if (corner != topmost_) up_ = 0;
      top_ = positions_[corner].z();
      topmost_ = corner;
      up_ += normal.z();
    }
  }
  // Normals that say nothing, as constant ones on a closed surface, add up to little.
  bool isInsideOut() const { return std::abs(agreed_) > 0.3 * area_ ? agreed_ < 0 : up_ < 0; }

 private:
  Eigen::Vector3d at(Index site) const { return positions_[site].cast<double>(); }

  std::span<const Eigen::Vector3f> positions_, along_;
  double area_ = 0, agreed_ = 0;  // doubled; of it what faces as `along` does, minus the rest
  float top_ = -std::numeric_limits<float>::infinity();
  Index topmost_ = kNone;
  double up_ = 0;  // of the triangles at the topmost site
};

}  // namespace

void windTriangles(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> along,
                   std::span<Triangle> triangles) {
  const auto beside = findNeighbors(triangles, static_cast<Index>(positions.size()));
  enum : std::uint8_t { kUnknown, kAsIs, kTurned };
  std::vector<std::uint8_t> sense(triangles.size(), kUnknown);
  std::vector<Index> members;
  for (Index start = 0; start < triangles.size(); ++start) {
    if (sense[start] != kUnknown) continue;
    Part part(positions, along);
    members = {start};
    sense[start] = kAsIs;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const bool isTurned = sense[members[i]] == kTurned;
      part.add(triangles[members[i]], isTurned);
      for (const Beside& other : beside[members[i]]) {
        if (other.triangle == kNone || sense[other.triangle] != kUnknown) continue;
        sense[other.triangle] = isTurned != other.isReversed ? kTurned : kAsIs;
        members.push_back(other.triangle);
      }
    }
    const std::uint8_t turned = part.isInsideOut() ? kAsIs : kTurned;
    for (const Index t : members) {
      if (sense[t] == turned) std::swap(triangles[t][1], triangles[t][2]);
    }
  }
}

std::vector<Triangle> triangulateFans(std::span<const Eigen::Vector3f> positions,
                                      std::span<const Eigen::Vector3f> normals, const Fans& fans,
                                      const TriangulationOptions& options, const Progress* progress) {
  std::vector<Triangle> triangles;
  const DisputedPatches disputed = findDisputed(fans, progress, &triangles);
  if (options.votes) addDisputed(positions, normals, fans, disputed, progress, triangles);
  if (progress) progress->throwIfCancelled();
  if (options.longestHole >= 3)
    closeHoles(positions, normals, static_cast<std::size_t>(options.longestHole), triangles);
  return triangles;
}

}  // namespace stipple
