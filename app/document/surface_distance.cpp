#include "app/document/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nanoflann.hpp>
#include <queue>
#include <unordered_map>

namespace stipple {

namespace {

// Enough neighbors that paths find a straight way, few enough that they do not jump to a sheet nearby.
constexpr int kGraphNeighbors = 12;

// The view of the sites that nanoflann asks for.
struct SiteCloud {
  const std::vector<Eigen::Vector3f>& positions;
  std::size_t kdtree_get_point_count() const { return positions.size(); }
  float kdtree_get_pt(std::size_t site, std::size_t axis) const {
    return positions[site][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, SiteCloud>, SiteCloud, 3>;

}  // namespace

struct SurfaceDistance::Tree {
  explicit Tree(const std::vector<Eigen::Vector3f>& positions) : cloud{positions}, index(3, cloud) {}
  SiteCloud cloud;
  KdTree index;
};

SurfaceDistance::SurfaceDistance(const PointSet& points, const Progress* progress)
    : sites_(weldAndOrder(points.positions())),
      neighborhoods_(findNeighborhoods(sites_, {.k = kGraphNeighbors}, progress)),
      tree_(std::make_unique<Tree>(sites_.positions)) {}

SurfaceDistance::~SurfaceDistance() = default;

Index SurfaceDistance::findNearest(const Eigen::Vector3f& place) const {
  std::uint32_t site = 0;
  float squaredDistance = 0;
  tree_->index.knnSearch(place.data(), 1, &site, &squaredDistance);
  return site;
}

std::vector<Reached> SurfaceDistance::findWithin(Index start, float radius) const {
  // Dijkstra; equal distances come by index, so that the order does not depend on the machine.
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::unordered_map<Index, float> best;
  std::vector<Reached> reached;
  front.emplace(0.0f, start);
  best[start] = 0;
  while (!front.empty()) {
    const auto [distance, site] = front.top();
    front.pop();
    if (distance > best[site]) continue;
    reached.push_back({site, distance});
    const auto neighbors = neighborhoods_.of(site);
    const auto squared = neighborhoods_.squaredDistancesOf(site);
    for (std::size_t n = 0; n < neighbors.size(); ++n) {
      const float through = distance + std::sqrt(squared[n]);
      if (through > radius) continue;
      const auto [known, isNew] = best.try_emplace(neighbors[n], through);
      if (!isNew && known->second <= through) continue;
      known->second = through;
      front.emplace(through, neighbors[n]);
    }
  }
  return reached;
}

std::vector<Index> SurfaceDistance::findPath(Index start, Index end) const {
  // A* (Hart et al. 1968): what is left is at least the straight way.
  struct Way {
    float distance;
    Index from;
  };
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::unordered_map<Index, Way> best{{start, {0, start}}};
  const auto left = [&](Index site) { return (sites_.positions[site] - sites_.positions[end]).norm(); };
  front.emplace(left(start), start);
  while (!front.empty() && front.top().second != end) {
    const auto [estimate, site] = front.top();
    front.pop();
    const float distance = best.at(site).distance;
    if (estimate > distance + left(site)) continue;
    const auto neighbors = neighborhoods_.of(site);
    const auto squared = neighborhoods_.squaredDistancesOf(site);
    for (std::size_t n = 0; n < neighbors.size(); ++n) {
      const float through = distance + std::sqrt(squared[n]);
      const auto [known, isNew] = best.try_emplace(neighbors[n], Way{through, site});
      if (!isNew && known->second.distance <= through) continue;
      known->second = {through, site};
      front.emplace(through + left(neighbors[n]), neighbors[n]);
    }
  }
  if (front.empty()) return {};
  std::vector<Index> path{end};
  while (path.back() != start) path.push_back(best.at(path.back()).from);
  std::ranges::reverse(path);
  return path;
}

}  // namespace stipple
