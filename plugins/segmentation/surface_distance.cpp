#include "plugins/segmentation/surface_distance.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>

namespace stipple {

namespace {

struct Front {
  float distance;
  Index site;
  friend bool operator>(const Front& a, const Front& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.site > b.site;
  }
};
using Queue = std::priority_queue<Front, std::vector<Front>, std::greater<>>;

// Dijkstra's algorithm from what is queued. lengthOf(edge) of kUnreached is no way; improve(from, to,
// distance) takes the distance, or refuses it where it is no shorter than the one at hand.
template <class Distance, class Length, class Improve>
void spread(const SurfaceGraph& graph, Queue& queue, const Distance& distanceOf, const Length& lengthOf,
            const Improve& improve) {
  while (!queue.empty()) {
    const Front front = queue.top();
    queue.pop();
    if (front.distance > distanceOf(front.site)) continue;
    for (Index e = graph.offsets[front.site]; e < graph.offsets[front.site + 1]; ++e) {
      const float reached = front.distance + lengthOf(e);
      if (reached < kUnreached && improve(front.site, graph.neighbors[e], reached)) {
        queue.push({reached, graph.neighbors[e]});
      }
    }
  }
}

// Labels spread to the nearest sites along edges that are not blocked.
void spreadLabels(const SurfaceGraph& graph, std::vector<std::int32_t>& labels) {
  std::vector<float> distance(graph.size(), kUnreached);
  Queue queue;
  for (Index site = 0; site < graph.size(); ++site) {
    if (labels[site] == 0) continue;
    distance[site] = 0;
    queue.push({0, site});
  }
  spread(
      graph, queue, [&](Index site) { return distance[site]; },
      [&](Index e) { return graph.blocked[e] ? kUnreached : graph.lengths[e]; },
      [&](Index from, Index to, float reached) {
        if (!(reached < distance[to])) return false;
        distance[to] = reached;
        labels[to] = labels[from];
        return true;
      });
}

// The label to which most edges lead out of some sites, the smallest of equals; 0: none.
std::int32_t findLabelOfBorder(const SurfaceGraph& graph, std::span<const Index> sites,
                               const std::vector<std::int32_t>& labels) {
  std::map<std::int32_t, int> edgesTo;
  for (const Index site : sites) {
    for (Index e = graph.offsets[site]; e < graph.offsets[site + 1]; ++e) {
      if (labels[graph.neighbors[e]] != 0) ++edgesTo[labels[graph.neighbors[e]]];
    }
  }
  std::int32_t best = 0;
  int most = 0;
  for (const auto& [label, count] : edgesTo) {
    if (count > most) {
      most = count;
      best = label;
    }
  }
  return best;
}

}  // namespace

void spreadDistance(const SurfaceGraph& graph, std::span<const Index> sources, std::vector<float>& distance) {
  Queue queue;
  for (const Index site : sources) {
    if (distance[site] == 0) continue;
    distance[site] = 0;
    queue.push({0, site});
  }
  spread(
      graph, queue, [&](Index site) { return distance[site]; },
      [&](Index e) { return graph.blocked[e] ? kUnreached : graph.lengths[e]; },
      [&](Index, Index to, float reached) {
        if (!(reached < distance[to])) return false;
        distance[to] = reached;
        return true;
      });
}

std::vector<Index> discAround(const SurfaceGraph& graph, Index center, float radius) {
  std::unordered_map<Index, float> distance = {{center, 0.f}};
  Queue queue;
  queue.push({0, center});
  spread(
      graph, queue, [&](Index site) { return distance.at(site); },
      [&](Index e) { return graph.blocked[e] ? kUnreached : graph.lengths[e]; },
      [&](Index, Index to, float reached) {
        if (reached > radius) return false;
        const auto [entry, isNew] = distance.try_emplace(to, reached);
        if (!isNew && !(reached < entry->second)) return false;
        entry->second = reached;
        return true;
      });
  std::vector<Index> sites;
  for (const auto& [site, reached] : distance) sites.push_back(site);
  std::sort(sites.begin(), sites.end());
  return sites;
}

void fillFromNearest(const SurfaceGraph& graph, std::vector<std::int32_t>& labels) {
  spreadLabels(graph, labels);
  // A piece is now labelled as a whole or not at all.
  const Pieces pieces = findPieces(graph);
  std::vector<Index> candidates(pieces.size());
  std::iota(candidates.begin(), candidates.end(), 0u);
  while (!candidates.empty()) {
    std::vector<std::pair<Index, std::int32_t>> taken;
    for (const Index piece : candidates) {
      if (labels[pieces.of(piece).front()] != 0) continue;
      const std::int32_t label = findLabelOfBorder(graph, pieces.of(piece), labels);
      if (label != 0) taken.emplace_back(piece, label);
    }
    candidates.clear();
    for (const auto& [piece, label] : taken) {
      for (const Index site : pieces.of(piece)) labels[site] = label;
    }
    for (const auto& [piece, label] : taken) {
      for (const Index site : pieces.of(piece)) {
        for (Index e = graph.offsets[site]; e < graph.offsets[site + 1]; ++e) {
          const Index j = graph.neighbors[e];
          if (labels[j] == 0) candidates.push_back(pieces.pieceOfSite[j]);
        }
      }
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  }
}

}  // namespace stipple
