#include "app/tools/graph_selection.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/geometry/site_sets.h"

namespace stipple {

namespace {

constexpr std::size_t kBlock = 8192;

// visit(neighbor) for the edges of a site that count.
template <class Visit>
void forLinked(const NeighborGraph& graph, Index site, const Visit& visit) {
  const auto neighbors = graph.neighborhoods.of(site);
  const auto squared = graph.neighborhoods.squaredDistancesOf(site);
  for (std::size_t n = 0; n < neighbors.size(); ++n) {
    const float reach = std::min(graph.reach[site], graph.reach[neighbors[n]]);
    if (squared[n] <= reach * reach) visit(neighbors[n]);
  }
}

}  // namespace

NeighborGraph buildNeighborGraph(const PointSet& points, const NeighborGraphOptions& options,
                                 const Progress* progress) {
  NeighborGraph graph;
  graph.sites = weldAndOrder(points.positions());
  graph.neighborhoods = findNeighborhoods(graph.sites, {.k = options.k}, progress);
  graph.reach.resize(graph.sites.size());
  parallelFor(graph.sites.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (auto site = static_cast<Index>(begin); site < end; ++site) {
      const auto squared = graph.neighborhoods.squaredDistancesOf(site);
      float sum = 0;
      for (const float s : squared) sum += std::sqrt(s);
      graph.reach[site] = options.gap * sum / static_cast<float>(std::max<std::size_t>(squared.size(), 1));
    }
  });
  return graph;
}

SelectionMask grow(const NeighborGraph& graph, std::span<const std::uint8_t> selection) {
  std::vector<std::uint8_t> before(graph.sites.size(), 0);
  for (std::size_t row = 0; row < selection.size(); ++row) {
    if (selection[row] != 0) before[graph.sites.siteOfPoint[row]] = 1;
  }
  // Neighborhoods are not mutual: an edge works both ways, whichever end lists it.
  std::vector<std::uint8_t> after = before;
  const auto select = [&](Index site) {
    std::atomic_ref<std::uint8_t>(after[site]).store(1, std::memory_order_relaxed);
  };
  parallelFor(graph.sites.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (auto site = static_cast<Index>(begin); site < end; ++site) {
      forLinked(graph, site, [&](Index neighbor) {
        if (before[site] != 0) select(neighbor);
        if (before[neighbor] != 0) select(site);
      });
    }
  });
  return scatterToPoints<std::uint8_t>(graph.sites, after);
}

SelectionMask shrink(const NeighborGraph& graph, std::span<const std::uint8_t> selection) {
  return invert(grow(graph, invert(SelectionMask(selection.begin(), selection.end()))));
}

std::vector<Index> findConnected(const NeighborGraph& graph, Index row) {
  SiteSets sets(graph.sites.size());
  for (Index site = 0; site < graph.sites.size(); ++site) {
    forLinked(graph, site, [&](Index neighbor) { sets.join(site, neighbor); });
  }
  const Index root = sets.rootOf(graph.sites.siteOfPoint[row]);
  std::vector<Index> rows;
  for (Index other = 0; other < graph.sites.siteOfPoint.size(); ++other) {
    if (sets.rootOf(graph.sites.siteOfPoint[other]) == root) rows.push_back(other);
  }
  return rows;
}

}  // namespace stipple
