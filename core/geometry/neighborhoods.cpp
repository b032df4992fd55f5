#include "core/geometry/neighborhoods.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <nanoflann.hpp>
#include <numeric>

#include "core/geometry/cell_index.h"
#include "core/geometry/nearest_kernel.h"
#include "core/geometry/position_cloud.h"

namespace stipple {

namespace {

using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PositionCloud>,
                                                   PositionCloud, 3, Index>;

// Squared distance (its bits order like the number) above the index: one comparison sorts by both.
using NeighborKey = std::uint64_t;
NeighborKey makeKey(float squaredDistance, Index site) {
  return static_cast<NeighborKey>(std::bit_cast<std::uint32_t>(squaredDistance)) << 32 | site;
}
Index siteOf(NeighborKey key) {
  return static_cast<Index>(key);
}
float squaredDistanceOf(NeighborKey key) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32));
}

// Buffers of one thread.
struct Scratch {
  std::vector<float> x, y, z, squaredDistances, packed;
  std::vector<Index> sites, slots;
  std::vector<NeighborKey> keys, spread;
  std::vector<std::uint32_t> starts;

  void gather(std::span<const Eigen::Vector3f> positions, const CellIndex::Block& block) {
    const std::size_t room = block.points + CandidateArrays::kPadding;
    if (x.size() < room) {
      for (auto* array : {&x, &y, &z, &squaredDistances}) array->resize(2 * room);
      sites.resize(2 * room);
      slots.resize(2 * room);
    }
    std::size_t count = 0;
    for (int r = 0; r < block.count; ++r) {
      const IndexRange range = block.ranges[static_cast<std::size_t>(r)];
      for (Index i = range.begin; i < range.end; ++i, ++count) {
        x[count] = positions[i].x();
        y[count] = positions[i].y();
        z[count] = positions[i].z();
        sites[count] = i;
      }
    }
    gathered = count;
  }
  std::size_t gathered = 0;
};

// A threshold that at least k and at most about k + 6 of the values stay below, by bisection from the count
// that a uniform surface would have.
float thresholdFor(const float* values, std::size_t count, std::size_t k, float limit) {
  float low = 0, high = limit, middle = limit * static_cast<float>(k + 3) / static_cast<float>(count);
  for (int round = 0; round < 12 && middle > low && middle < high; ++round) {
    const std::size_t within = countUpTo(values, count, middle);
    if (within >= k && within <= k + 6) return middle;
    (within < k ? low : high) = middle;
    middle = low + (high - low) * 0.5f;
  }
  return high;
}

// Ascending. The squared distances of a surface's points to one of them are spread evenly up to `most`: with
// as many buckets as keys few share one.
void sortKeys(Scratch& s, float most) {
  constexpr std::size_t kFew = 12;
  constexpr std::uint32_t kCrowd = 16;
  const std::size_t count = s.keys.size();
  const float perBucket = static_cast<float>(count) / most;
  if (count < kFew || !(perBucket > 0) || std::isinf(perBucket))
    return std::sort(s.keys.begin(), s.keys.end());
  const auto bucketOf = [&](NeighborKey key) {
    return std::min(static_cast<std::size_t>(squaredDistanceOf(key) * perBucket), count - 1);
  };
  s.starts.assign(count + 1, 0);
  for (const NeighborKey key : s.keys) ++s.starts[bucketOf(key) + 1];
  if (*std::ranges::max_element(s.starts) > kCrowd) return std::sort(s.keys.begin(), s.keys.end());
  std::partial_sum(s.starts.begin(), s.starts.end(), s.starts.begin());
  s.spread.resize(count);
  for (const NeighborKey key : s.keys) s.spread[s.starts[bucketOf(key)]++] = key;
  for (std::size_t i = 1; i < count; ++i) {
    const NeighborKey key = s.spread[i];
    std::size_t to = i;
    for (; to > 0 && s.spread[to - 1] > key; --to) s.spread[to] = s.spread[to - 1];
    s.spread[to] = key;
  }
  s.keys.swap(s.spread);
}

// Fills keys with the k nearest candidates, ascending; false where fewer than k lie within `reach`.
bool selectNearest(Scratch& s, const Eigen::Vector3f& position, std::size_t k, float reach) {
  if (!(reach > 0)) return false;
  const float limit = std::min(reach * reach, std::numeric_limits<float>::max());
  const std::size_t within =
      collectWithin({s.x.data(), s.y.data(), s.z.data(), s.gathered}, position.x(), position.y(),
                    position.z(), limit, s.squaredDistances.data(), s.slots.data());
  if (within < k) return false;
  float threshold = limit;
  if (within > k + 6)
    threshold = std::isinf(reach) ? limit : thresholdFor(s.squaredDistances.data(), within, k, limit);
  // Without a branch, which would be guessed wrong every other time.
  s.keys.resize(within);
  std::size_t kept = 0;
  for (std::size_t c = 0; c < within; ++c) {
    s.keys[kept] = makeKey(s.squaredDistances[c], s.sites[s.slots[c]]);
    kept += s.squaredDistances[c] <= threshold;
  }
  s.keys.resize(kept);
  if (s.keys.size() > 4 * k + 64) {
    std::nth_element(s.keys.begin(), s.keys.begin() + static_cast<std::ptrdiff_t>(k), s.keys.end());
    s.keys.resize(k);
  }
  sortKeys(s, threshold);
  s.keys.resize(k);
  return true;
}

void append(const Scratch& s, std::vector<Index>& neighbors, std::vector<float>& squaredDistances) {
  for (const NeighborKey key : s.keys) {
    neighbors.push_back(siteOf(key));
    squaredDistances.push_back(squaredDistanceOf(key));
  }
}

}  // namespace

struct NeighborSearch::Impl {
  Impl(std::span<const Eigen::Vector3f> points, int k)
      : positions(points),
        typicalK(std::max(k, 1)),
        cells(points, std::max(kPointsPerCellAndNeighbor * typicalK, kLeastPointsPerCell)) {}

  // A surface of density d crosses about 1.5 A / c^2 cells of size c, and the ball of radius c that a block
  // of 27 cells is sure to hold has pi d c^2 points: 1.3 times the k wanted.
  static constexpr double kPointsPerCellAndNeighbor = 0.28;
  // An occupied cell has a point: for a few neighbors the rule would ask for the finest cells that there are.
  static constexpr double kLeastPointsPerCell = 1.5;

  std::span<const Eigen::Vector3f> positions;
  int typicalK;
  CellIndex cells;

  const KdTree& tree() const {
    std::call_once(treeBuilt, [&] {
      adaptor = {positions};
      kdTree = std::make_unique<KdTree>(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    });
    return *kdTree;
  }

  // Every cell of the range, at the finest level that is not overcrowded.
  void findInRange(IndexRange range, int level, std::size_t k, Scratch& s, Neighborhoods& rows) const {
    for (Index begin = range.begin; begin < range.end;) {
      const std::uint64_t cell = cells.cellOf(begin, level);
      Index end = begin + 1;
      while (end < range.end && cells.cellOf(end, level) == cell) ++end;
      const CellIndex::Block block = cells.blockAround(cell, level);
      const bool crowded = block.points > 40 * k + 400;
      if (crowded && level > 0) {
        findInRange({begin, end}, level - 1, k, s, rows);
      } else {
        // One far outlier stretches the lattice until all other sites share a cell: those go to the tree.
        bool gathered = false;
        for (Index site = begin; site < end; ++site) {
          if (!gathered && !crowded) s.gather(positions, block);
          gathered =
              !crowded && selectNearest(s, positions[site], k, cells.reachOf(positions[site], cell, level));
          if (!gathered) findAlone(site, level + 1, k, s);
          append(s, rows.neighbors, rows.squaredDistances);
          rows.offsets.push_back(rows.neighbors.size());
        }
      }
      begin = end;
    }
  }

  // One site, from `level` upward, at last with the tree.
  void findAlone(Index site, int level, std::size_t k, Scratch& s) const {
    for (const int top = std::min(level + 2, MortonLattice::kBits); level <= top; ++level) {
      const std::uint64_t cell = cells.cellOf(site, level);
      const CellIndex::Block block = cells.blockAround(cell, level);
      if (block.points > 100 * k + 1000) break;
      if (block.points <= k) continue;
      s.gather(positions, block);
      if (selectNearest(s, positions[site], k, cells.reachOf(positions[site], cell, level))) return;
    }
    findInTree(site, k, s);
  }

  void findInTree(Index site, std::size_t k, Scratch& s) const {
    std::vector<Index> found(k + 1);
    std::vector<float> squared(k + 1);
    found.resize(tree().knnSearch(positions[site].data(), k + 1, found.data(), squared.data()));
    s.keys.clear();
    for (std::size_t j = 0; j < found.size(); ++j) {
      if (found[j] != site) s.keys.push_back(makeKey(squared[j], found[j]));
    }
    std::sort(s.keys.begin(), s.keys.end());
    s.keys.resize(std::min(k, s.keys.size()));
  }

  // All within the radius, nearest first.
  void findInBall(Index site, float radius, Scratch& s) const {
    std::vector<std::pair<Index, float>> found;
    nanoflann::SearchParams unsorted(32, 0, false);
    tree().radiusSearch(positions[site].data(), radius * radius, found, unsorted);
    s.keys.clear();
    for (const auto& [neighbor, squared] : found) {
      if (neighbor != site) s.keys.push_back(makeKey(squared, neighbor));
    }
    std::sort(s.keys.begin(), s.keys.end());
  }

  std::size_t available(int k) const {
    return std::min<std::size_t>(static_cast<std::size_t>(std::max(k, 0)),
                                 positions.empty() ? 0 : positions.size() - 1);
  }

  mutable std::once_flag treeBuilt;
  mutable PositionCloud adaptor;
  mutable std::unique_ptr<KdTree> kdTree;
};

NeighborSearch::NeighborSearch(std::span<const Eigen::Vector3f> positions, int typicalK)
    : impl_(std::make_unique<Impl>(positions, typicalK)) {}
NeighborSearch::~NeighborSearch() = default;
NeighborSearch::NeighborSearch(NeighborSearch&&) noexcept = default;
NeighborSearch& NeighborSearch::operator=(NeighborSearch&&) noexcept = default;

void NeighborSearch::findNearest(Index begin, Index end, int k, Neighborhoods& rows) const {
  if (rows.offsets.empty()) rows.offsets.push_back(0);
  Scratch scratch;
  const std::size_t wanted = impl_->available(k);
  if (wanted == 0) {
    rows.offsets.resize(rows.offsets.size() + (end - begin), rows.neighbors.size());
    return;
  }
  impl_->findInRange({begin, end}, impl_->cells.hashedLevel(), wanted, scratch, rows);
}

void NeighborSearch::findNearest(Index site, int k, std::vector<Index>& neighbors,
                                 std::vector<float>& squaredDistances) const {
  neighbors.clear();
  squaredDistances.clear();
  const std::size_t wanted = impl_->available(k);
  if (wanted == 0) return;
  Scratch scratch;
  // Each level up holds four times the neighbors.
  int level = impl_->cells.hashedLevel();
  for (int held = impl_->typicalK; held < k; held *= 4) ++level;
  impl_->findAlone(site, std::min(level, MortonLattice::kBits), wanted, scratch);
  append(scratch, neighbors, squaredDistances);
}

void NeighborSearch::findWithin(Index site, float radius, std::vector<Index>& neighbors,
                                std::vector<float>& squaredDistances) const {
  neighbors.clear();
  squaredDistances.clear();
  Scratch scratch;
  impl_->findInBall(site, radius, scratch);
  append(scratch, neighbors, squaredDistances);
}

namespace {

// Joins the compressed rows of blocks, in order.
Neighborhoods concatenate(std::vector<Neighborhoods>& parts, std::size_t sites) {
  Neighborhoods all;
  std::size_t total = 0;
  for (const Neighborhoods& part : parts) total += part.neighbors.size();
  all.offsets.reserve(sites + 1);
  all.neighbors.reserve(total);
  all.squaredDistances.reserve(total);
  all.offsets.push_back(0);
  for (Neighborhoods& part : parts) {
    const std::size_t base = all.neighbors.size();
    for (std::size_t r = 1; r < part.offsets.size(); ++r) all.offsets.push_back(base + part.offsets[r]);
    all.neighbors.insert(all.neighbors.end(), part.neighbors.begin(), part.neighbors.end());
    all.squaredDistances.insert(all.squaredDistances.end(), part.squaredDistances.begin(),
                                part.squaredDistances.end());
    part = {};
  }
  return all;
}

// Replaces the rows whose k-th neighbor is nearer than epsilon by the ball of epsilon.
Neighborhoods widenToBalls(const Neighborhoods& nearest, const NeighborSearch& search, Index begin,
                           const NeighborhoodOptions& options) {
  Neighborhoods widened;
  widened.offsets.push_back(0);
  std::vector<Index> ball;
  std::vector<float> squared;
  for (Index row = 0; row + 1 < nearest.offsets.size(); ++row) {
    const auto kept = nearest.of(row);
    const auto distances = nearest.squaredDistancesOf(row);
    const bool narrow = !kept.empty() && distances.back() < options.epsilon * options.epsilon;
    if (narrow) search.findWithin(begin + row, options.epsilon, ball, squared);
    widened.neighbors.insert(widened.neighbors.end(), kept.begin(), kept.end());
    widened.squaredDistances.insert(widened.squaredDistances.end(), distances.begin(), distances.end());
    if (narrow && ball.size() > kept.size()) {
      const auto room = static_cast<std::size_t>(std::max<std::ptrdiff_t>(options.cap - std::ssize(kept), 1));
      const std::size_t stride = (ball.size() - kept.size() + room - 1) / room;
      for (std::size_t j = kept.size() + stride - 1; j < ball.size(); j += stride) {
        widened.neighbors.push_back(ball[j]);
        widened.squaredDistances.push_back(squared[j]);
      }
    }
    widened.offsets.push_back(widened.neighbors.size());
  }
  return widened;
}

Neighborhoods findInBlocks(const Sites& sites, const NeighborhoodOptions& options, const Progress* progress) {
  constexpr std::size_t kBlock = 4096;
  const NeighborSearch search(sites.positions, options.k);
  std::vector<Neighborhoods> parts((sites.size() + kBlock - 1) / kBlock);
  parallelFor(
      sites.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        Neighborhoods& part = parts[begin / kBlock];
        search.findNearest(static_cast<Index>(begin), static_cast<Index>(end), options.k, part);
        if (options.epsilon > 0) part = widenToBalls(part, search, static_cast<Index>(begin), options);
      },
      progress);
  return concatenate(parts, sites.size());
}

}  // namespace

Neighborhoods findNeighborhoods(const Sites& sites, const NeighborhoodOptions& options,
                                const Progress* progress) {
  if (options.k < 1) throw InvalidInput(fmt::format("k is {}, expected at least 1", options.k));
  if (!(options.epsilon >= 0))
    throw InvalidInput(fmt::format("epsilon is {}, expected >= 0", options.epsilon));
  requireUsableScale(sites);
  return findInBlocks(sites, options, progress);
}

float medianSpacing(const Sites& sites) {
  if (sites.size() < 2) return 0;
  std::vector<float> squared = findInBlocks(sites, {.k = 1}, nullptr).squaredDistances;
  if (squared.empty()) return std::numeric_limits<float>::infinity();
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::sqrt(*middle);
}

}  // namespace stipple
