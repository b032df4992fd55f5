#include "app/document/surface_distance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <queue>
#include <unordered_map>

namespace stipple {

namespace {

// Enough neighbors that paths find a straight way, few enough that they do not jump to a sheet nearby.
constexpr int kGraphNeighbors = 12;

// Sites by rising distance, equal ones by index: distances are not negative, so that they rise as their bits
// do. A heap with four children a node.
class SiteQueue {
 public:
  bool empty() const { return keys_.empty(); }

  void push(float distance, Index site) {
    const std::uint64_t key = std::uint64_t{std::bit_cast<std::uint32_t>(distance)} << 32 | site;
    std::size_t place = keys_.size();
    keys_.push_back(key);
    while (place > 0 && key < keys_[(place - 1) / 4]) {
      keys_[place] = keys_[(place - 1) / 4];
      place = (place - 1) / 4;
    }
    keys_[place] = key;
  }

  Reached pop() {
    const std::uint64_t first = keys_.front(), last = keys_.back();
    keys_.pop_back();
    if (!keys_.empty()) sink(last);
    return {.site = static_cast<Index>(first),
            .distance = std::bit_cast<float>(static_cast<std::uint32_t>(first >> 32))};
  }

 private:
  // Puts the key where the top was taken from.
  void sink(std::uint64_t key) {
    std::size_t place = 0;
    for (std::size_t child = 1; child < keys_.size(); child = 4 * place + 1) {
      const std::size_t end = std::min(child + 4, keys_.size());
      std::size_t least = child;
      for (std::size_t other = child + 1; other < end; ++other) {
        if (keys_[other] < keys_[least]) least = other;
      }
      if (key <= keys_[least]) break;
      keys_[place] = keys_[least];
      place = least;
    }
    keys_[place] = key;
  }

  std::vector<std::uint64_t> keys_;
};

// What a search needs for each site. Kept between searches: an entry counts only where it has the stamp of
// the search that goes on.
class Front {
 public:
  explicit Front(Index size) : entries_(size) {}

  void begin() {
    if (++stamp_ != 0) return;
    std::ranges::fill(entries_, Entry{});
    stamp_ = 1;
  }
  /// Notes the distance where none as short is known.
  bool improve(Index site, float distance) {
    Entry& entry = entries_[site];
    if (entry.stamp == stamp_ && entry.distance <= distance) return false;
    entry = {.stamp = stamp_, .distance = distance};
    return true;
  }
  float distance(Index site) const { return entries_[site].distance; }

  SiteQueue queue;

 private:
  struct Entry {
    std::uint32_t stamp = 0;
    float distance = 0;
  };
  std::vector<Entry> entries_;
  std::uint32_t stamp_ = 0;
};

}  // namespace

// Those that no search uses at the moment.
struct SurfaceDistance::Fronts {
  std::mutex mutex;
  std::vector<std::unique_ptr<Front>> idle;

  std::unique_ptr<Front> take(Index size) {
    const std::lock_guard lock(mutex);
    if (idle.empty()) return std::make_unique<Front>(size);
    auto front = std::move(idle.back());
    idle.pop_back();
    return front;
  }
  void giveBack(std::unique_ptr<Front> front) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(front));
  }
};

SurfaceDistance::SurfaceDistance(const PointSet& points, const Progress* progress)
    : sites_(weldAndOrder(points.positions())),
      offsets_(sites_.size() + 1, 0),
      points_(points.size()),
      neighborhoods_(findNeighborhoods(sites_, {.k = kGraphNeighbors}, progress)),
      nearest_(sites_.size() > 0 ? std::make_unique<NearestPoint>(sites_.positions) : nullptr),
      fronts_(std::make_unique<Fronts>()) {
  for (const Index site : sites_.siteOfPoint) ++offsets_[site + 1];
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  std::vector<Index> next(offsets_.begin(), offsets_.end() - 1);
  for (Index point = 0; point < points_.size(); ++point) points_[next[sites_.siteOfPoint[point]]++] = point;
}

SurfaceDistance::~SurfaceDistance() = default;

Index SurfaceDistance::findNearest(const Eigen::Vector3f& place) const {
  return nearest_->find(place);
}

std::vector<Reached> SurfaceDistance::findWithin(Index start, float radius) const {
  // Dijkstra; equal distances come by index, so that the order does not depend on the machine.
  auto front = fronts_->take(sites_.size());
  front->begin();
  SiteQueue& queue = front->queue;
  std::vector<Reached> reached;
  front->improve(start, 0);
  queue.push(0, start);
  while (!queue.empty()) {
    const Reached next = queue.pop();
    if (next.distance > front->distance(next.site)) continue;
    reached.push_back(next);
    const auto neighbors = neighborhoods_.of(next.site);
    const auto squared = neighborhoods_.squaredDistancesOf(next.site);
    for (std::size_t n = 0; n < neighbors.size(); ++n) {
      const float through = next.distance + std::sqrt(squared[n]);
      if (through <= radius && front->improve(neighbors[n], through)) queue.push(through, neighbors[n]);
    }
  }
  fronts_->giveBack(std::move(front));
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
