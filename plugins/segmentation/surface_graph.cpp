#include "plugins/segmentation/surface_graph.h"

#include <algorithm>
#include <limits>

namespace stipple {

namespace {

// Compressed rows of the fans and their transpose, each row ascending without repeats.
void collectNeighbors(const Fans& fans, Index size, SurfaceGraph& graph) {
  std::vector<Index> counts(size + 1, 0);
  for (Index i = 0; i < size; ++i) {
    counts[i + 1] += static_cast<Index>(fans.of(i).size());
    for (const Index j : fans.of(i)) ++counts[j + 1];
  }
  for (Index i = 0; i < size; ++i) counts[i + 1] += counts[i];
  std::vector<Index> both(counts[size]), end(counts.begin(), counts.end() - 1);
  for (Index i = 0; i < size; ++i) {
    for (const Index j : fans.of(i)) {
      both[end[i]++] = j;
      both[end[j]++] = i;
    }
  }
  graph.offsets.resize(1);
  for (Index i = 0; i < size; ++i) {
    const auto begin = both.begin() + counts[i], stop = both.begin() + counts[i + 1];
    std::sort(begin, stop);
    graph.neighbors.insert(graph.neighbors.end(), begin, std::unique(begin, stop));
    graph.offsets.push_back(static_cast<Index>(graph.neighbors.size()));
  }
}

}  // namespace

std::optional<Index> SurfaceGraph::findEdge(Index from, Index to) const {
  const auto begin = neighbors.begin() + offsets[from], end = neighbors.begin() + offsets[from + 1];
  const auto found = std::lower_bound(begin, end, to);
  if (found == end || *found != to) return std::nullopt;
  return static_cast<Index>(found - neighbors.begin());
}

SurfaceGraph buildSurfaceGraph(const Discretization& d, const std::function<bool(Index, Index)>& isBlocked,
                               const Progress* progress) {
  SurfaceGraph graph;
  collectNeighbors(d.fans, d.size(), graph);
  graph.lengths.resize(graph.neighbors.size());
  graph.blocked.resize(graph.neighbors.size());
  parallelFor(
      d.size(), 2048,
      [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
          for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
            const Index j = graph.neighbors[e];
            graph.lengths[e] = (d.sites.positions[i] - d.sites.positions[j]).norm();
            graph.blocked[e] = isBlocked(i, j);
          }
        }
      },
      progress);
  return graph;
}

bool isJoined(const SurfaceGraph& graph, Index from, Index to, int edges) {
  std::vector<Index> reached = {from};
  std::size_t next = 0;
  for (int ring = 0; ring < edges; ++ring) {
    for (const std::size_t end = reached.size(); next < end; ++next) {
      for (Index e = graph.offsets[reached[next]]; e < graph.offsets[reached[next] + 1]; ++e) {
        const Index j = graph.neighbors[e];
        if (graph.blocked[e] || std::find(reached.begin(), reached.end(), j) != reached.end()) continue;
        if (j == to) return true;
        reached.push_back(j);
      }
    }
  }
  return from == to;
}

Pieces findPieces(const SurfaceGraph& graph) {
  constexpr Index kNone = std::numeric_limits<Index>::max();
  Pieces pieces;
  pieces.pieceOfSite.assign(graph.size(), kNone);
  pieces.rankOfSite.resize(graph.size());
  std::vector<Index>& reached = pieces.sites;
  for (Index first = 0; first < graph.size(); ++first) {
    if (pieces.pieceOfSite[first] != kNone) continue;
    const Index piece = pieces.size();
    const std::size_t begin = reached.size();
    pieces.pieceOfSite[first] = piece;
    reached.push_back(first);
    for (std::size_t next = begin; next < reached.size(); ++next) {
      const Index i = reached[next];
      for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
        const Index j = graph.neighbors[e];
        if (graph.blocked[e] || pieces.pieceOfSite[j] != kNone) continue;
        pieces.pieceOfSite[j] = piece;
        reached.push_back(j);
      }
    }
    std::sort(reached.begin() + static_cast<std::ptrdiff_t>(begin), reached.end());
    pieces.offsets.push_back(static_cast<Index>(reached.size()));
    for (std::size_t n = begin; n < reached.size(); ++n)
      pieces.rankOfSite[reached[n]] = static_cast<Index>(n - begin);
  }
  return pieces;
}

}  // namespace stipple
