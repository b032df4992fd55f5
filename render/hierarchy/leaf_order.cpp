#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/geometry/morton.h"
#include "render/hierarchy/build.h"

namespace stipple {

namespace {

// Sorts points by the 43 highest of 63 bits of their Morton codes, 14 to 15 an axis: finer than the spacing
// of any scan that fits into memory. A first pass over all of them makes buckets that fit into the cache,
// where the others run. Equal codes keep the order of the points.
class MortonSort {
 public:
  MortonSort(std::span<const Eigen::Vector3f> positions, const Progress* progress)
      : positions_(positions), progress_(progress), codes_(positions.size()), entries_(positions.size()) {
    const std::size_t blocks = std::clamp<std::size_t>(positions.size() / kLeastBlock, 1, kMostBlocks);
    block_ = std::max<std::size_t>(1, (positions.size() + blocks - 1) / blocks);
    counts_.resize((positions.size() + block_ - 1) / block_);
  }

  RawVector<PlacedPoint> sort() {
    fillBuckets();
    RawVector<PlacedPoint> order(positions_.size());
    parallelFor(
        kBuckets, 1,
        [&](std::size_t bucket, std::size_t) {
          const Index begin = begins_[bucket], size = begins_[bucket + 1] - begin;
          place(sortBucket(begin, size), std::span(order).subspan(begin, size));
        },
        progress_);
    return order;
  }

 private:
  // 32 bits of the code below those of the bucket, and the point.
  using Entry = std::uint64_t;
  static Entry entryOf(std::uint64_t code, std::size_t point) {
    return code >> (3 * MortonLattice::kBits - kDigitBits - 32) << 32 | point;
  }
  static Index pointOf(Entry entry) { return static_cast<Index>(entry); }

  static constexpr int kDigitBits = 11, kBuckets = 1 << kDigitBits, kPasses = 3;
  static constexpr std::array<int, kPasses> kShifts{32, 42, 53};
  static constexpr std::size_t kLeastBlock = 1 << 16, kMostBlocks = 16, kSmall = 256;
  // Points between asking for memory and using it.
  static constexpr std::size_t kAhead = 16;
  using Counts = std::array<Index, kBuckets>;

  static std::size_t bucketOf(std::uint64_t code) { return code >> (3 * MortonLattice::kBits - kDigitBits); }
  // 10, 11 and 11 bits.
  static std::size_t digitOf(Entry entry, int pass) {
    return entry >> kShifts[pass] & (pass == 0 ? kBuckets / 2 - 1 : kBuckets - 1);
  }

  void fillBuckets() {
    const MortonLattice lattice = fitMortonLattice(positions_);
    forBlocks([&](std::size_t begin, std::size_t end) {
      Counts& count = counts_[begin / block_];
      count.fill(0);
      for (std::size_t i = begin; i < end; ++i) {
        codes_[i] = lattice.codeOf(positions_[i]);
        ++count[bucketOf(codes_[i])];
      }
    });
    Index sum = 0;
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
      begins_[bucket] = sum;
      for (Counts& count : counts_) sum += std::exchange(count[bucket], sum);
    }
    begins_[kBuckets] = sum;
    forBlocks([&](std::size_t begin, std::size_t end) {
      Counts& next = counts_[begin / block_];
      for (std::size_t i = begin; i < end; ++i) entries_[next[bucketOf(codes_[i])]++] = entryOf(codes_[i], i);
    });
  }

  template <class Body>
  void forBlocks(const Body& body) {
    parallelFor(positions_.size(), block_, body, progress_);
  }

  // The entries of a bucket, in one memory or the other.
  std::span<const Entry> sortBucket(Index begin, Index size) {
    std::span<Entry> from(entries_.data() + begin, size), to(codes_.data() + begin, size);
    if (size < kSmall) {
      std::ranges::sort(from);
      return from;
    }
    std::array<Counts, kPasses> counts{};
    for (const Entry entry : from) {
      for (int pass = 0; pass < kPasses; ++pass) ++counts[pass][digitOf(entry, pass)];
    }
    for (int pass = 0; pass < kPasses; ++pass) {
      Index sum = 0;
      for (Index& count : counts[pass]) sum += std::exchange(count, sum);
      for (const Entry entry : from) to[counts[pass][digitOf(entry, pass)]++] = entry;
      std::swap(from, to);
    }
    return from;
  }

  void place(std::span<const Entry> entries, std::span<PlacedPoint> order) const {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i + kAhead < entries.size()) __builtin_prefetch(&positions_[pointOf(entries[i + kAhead])]);
      const Index point = pointOf(entries[i]);
      order[i] = {positions_[point], point};
    }
  }

  std::span<const Eigen::Vector3f> positions_;
  const Progress* progress_;
  std::size_t block_ = 1;
  std::vector<Counts> counts_;
  std::array<Index, kBuckets + 1> begins_{};
  RawVector<std::uint64_t> codes_;  // room for sorting once the buckets are filled
  RawVector<Entry> entries_;
};

int longestAxis(std::span<const PlacedPoint> points) {
  Eigen::Vector3f low = points.front().position, high = low;
  for (const PlacedPoint& p : points) {
    low = low.cwiseMin(p.position);
    high = high.cwiseMax(p.position);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

// Moves the `left` points that are smallest along the axis to the front.
void split(std::span<PlacedPoint> points, std::size_t left, int axis) {
  std::nth_element(
      points.begin(), points.begin() + static_cast<std::ptrdiff_t>(left), points.end(),
      [axis](const PlacedPoint& a, const PlacedPoint& b) { return a.position[axis] < b.position[axis]; });
}

}  // namespace

void sortByKdOrder(std::span<PlacedPoint> points, const Progress* progress) {
  constexpr std::size_t kParallel = 1 << 17;
  if (points.size() <= Hierarchy::kArity) return;
  // The left part is full: a power of two, so that aligned blocks of slots are subtrees.
  const std::size_t left = std::bit_floor(points.size() - 1);
  split(points, left, longestAxis(points));
  const std::array parts = {points.first(left), points.subspan(left)};
  if (points.size() < kParallel) {
    for (const std::span<PlacedPoint>& part : parts) sortByKdOrder(part, progress);
    return;
  }
  parallelFor(
      2, 1, [&](std::size_t part, std::size_t) { sortByKdOrder(parts[part], progress); }, progress);
}

RawVector<PlacedPoint> orderLeaves(std::span<const Eigen::Vector3f> positions, LeafOrder order,
                                   const Progress* progress) {
  RawVector<PlacedPoint> points = MortonSort(positions, progress).sort();
  // From the Morton order, where points that stand together fall on one side together: branches are foreseen.
  if (order == LeafOrder::kKd) sortByKdOrder(points, progress);
  return points;
}

}  // namespace stipple
