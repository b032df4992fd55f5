#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/geometry/morton.h"
#include "render/hierarchy/build.h"

namespace stipple {

namespace {

struct CodedPoint {
  std::uint64_t code;
  Index point;
};

// Stable radix sort by the 44 highest of 63 bits, 14 to 15 an axis: finer than the spacing of any scan that
// fits into memory. Blocks count and scatter in parallel.
class MortonSort {
 public:
  MortonSort(RawVector<CodedPoint>& points, const Progress* progress) : points_(points), progress_(progress) {
    const std::size_t blocks = std::clamp<std::size_t>(points.size() / kLeastBlock, 1, kMostBlocks);
    block_ = std::max<std::size_t>(1, (points.size() + blocks - 1) / blocks);
    counts_.resize((points.size() + block_ - 1) / block_);
  }

  void sort() {
    RawVector<CodedPoint> other(points_.size());
    for (int shift = 3 * MortonLattice::kBits - 4 * kDigitBits; shift < 3 * MortonLattice::kBits;
         shift += kDigitBits) {
      count(shift);
      if (!accumulate()) continue;
      scatter(shift, other);
      points_.swap(other);
    }
  }

 private:
  static constexpr int kDigitBits = 11, kDigits = 1 << kDigitBits;
  static constexpr std::size_t kLeastBlock = 1 << 16, kMostBlocks = 16;

  static std::size_t digitOf(const CodedPoint& p, int shift) { return p.code >> shift & (kDigits - 1); }

  void count(int shift) {
    parallelFor(
        points_.size(), block_,
        [&](std::size_t begin, std::size_t end) {
          std::array<Index, kDigits>& count = counts_[begin / block_];
          count.fill(0);
          for (std::size_t i = begin; i < end; ++i) ++count[digitOf(points_[i], shift)];
        },
        progress_);
  }

  // Counts become places; false where all points share the digit.
  bool accumulate() {
    Index sum = 0;
    bool isNeeded = true;
    for (int digit = 0; digit < kDigits; ++digit) {
      const Index before = sum;
      for (std::array<Index, kDigits>& count : counts_) sum += std::exchange(count[digit], sum);
      if (sum - before == points_.size()) isNeeded = false;
    }
    return isNeeded;
  }

  void scatter(int shift, RawVector<CodedPoint>& other) {
    parallelFor(
        points_.size(), block_,
        [&](std::size_t begin, std::size_t end) {
          std::array<Index, kDigits>& place = counts_[begin / block_];
          for (std::size_t i = begin; i < end; ++i) other[place[digitOf(points_[i], shift)]++] = points_[i];
        },
        progress_);
  }

  RawVector<CodedPoint>& points_;
  const Progress* progress_;
  std::size_t block_ = 1;
  std::vector<std::array<Index, kDigits>> counts_;
};

RawVector<PlacedPoint> mortonOrder(std::span<const Eigen::Vector3f> positions, const Progress* progress) {
  const MortonLattice lattice = fitMortonLattice(positions);
  RawVector<CodedPoint> points(positions.size());
  parallelFor(
      points.size(), 1 << 16,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          points[i] = {lattice.codeOf(positions[i]), static_cast<Index>(i)};
      },
      progress);
  MortonSort(points, progress).sort();
  RawVector<PlacedPoint> order(points.size());
  parallelFor(
      points.size(), 1 << 14,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) order[i] = {positions[points[i].point], points[i].point};
      },
      progress);
  return order;
}

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

void splitRecursively(std::span<PlacedPoint> points, const Progress* progress) {
  constexpr std::size_t kParallel = 1 << 17;
  if (points.size() <= Hierarchy::kArity) return;
  // The left part is full: a power of two, so that aligned blocks of slots are subtrees.
  const std::size_t left = std::bit_floor(points.size() - 1);
  split(points, left, longestAxis(points));
  const std::array parts = {points.first(left), points.subspan(left)};
  if (points.size() < kParallel) {
    for (const std::span<PlacedPoint>& part : parts) splitRecursively(part, progress);
    return;
  }
  parallelFor(
      2, 1, [&](std::size_t part, std::size_t) { splitRecursively(parts[part], progress); }, progress);
}

}  // namespace

RawVector<PlacedPoint> orderLeaves(std::span<const Eigen::Vector3f> positions, LeafOrder order,
                                   const Progress* progress) {
  RawVector<PlacedPoint> points = mortonOrder(positions, progress);
  // From the Morton order, where points that stand together fall on one side together: branches are foreseen.
  if (order == LeafOrder::kKd) splitRecursively(points, progress);
  return points;
}

}  // namespace stipple
