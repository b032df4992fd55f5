#include "render/hierarchy/sort_leaves.h"

#include <algorithm>
#include <array>

#include "render/hierarchy/block_estimates.h"
#include "render/hierarchy/build.h"

namespace stipple {

namespace {

void fitNormals(std::span<Splat> leaves, std::span<const PlacedPoint> slots) {
  std::uint32_t normal = 0;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (i % kLeavesOfBlock == 0) {
      const Eigen::Vector3f n = fitBlockNormal(slots, i / kLeavesOfBlock);
      normal = packNormal({n.x(), n.y(), n.z()});
    }
    leaves[i].shape = (leaves[i].shape & 0xff000000) | normal;
  }
}

}  // namespace

std::vector<NodeRange> sortLeaves(Hierarchy& hierarchy, Index block, const LeafSorting& options) {
  const Index begin = block * kSortedLeaves, count = std::min(kSortedLeaves, hierarchy.leafCount() - begin);
  const std::span<Splat> leaves = hierarchy.editSplats().subspan(begin, count);
  const std::span<Index> points = std::span(hierarchy.pointOfSlot).subspan(begin, count);
  std::vector<PlacedPoint> slots(count);
  for (Index i = 0; i < count; ++i) slots[i] = {{leaves[i].x, leaves[i].y, leaves[i].z}, i};
  sortByKdOrder(slots, nullptr);

  const std::vector<Splat> oldLeaves(leaves.begin(), leaves.end());
  const std::vector<Index> oldPoints(points.begin(), points.end());
  for (Index i = 0; i < count; ++i) {
    const Index from = slots[i].point;
    leaves[i] = oldLeaves[from];
    points[i] = oldPoints[from];
    hierarchy.slotOfPoint[points[i]] = begin + i;
  }
  if (options.fitsNormals) fitNormals(leaves, slots);
  refitLeaves(hierarchy, begin, std::size_t{begin} + count, kSortedLevels);
  std::vector<NodeRange> changed{{begin, begin + count}};
  for (int level = 1; level <= kSortedLevels && level < hierarchy.levelCount(); ++level) {
    const Index first = hierarchy.levelBegin(level);
    const int shift = 2 * level;
    changed.push_back({first + (begin >> shift), first + ((begin + count - 1) >> shift) + 1});
  }
  // Above the block there is one node a level.
  const std::array<Index, 1> any{begin};
  for (const NodeRange& range : refit(hierarchy, any)) {
    if (range.end > changed.back().end) changed.push_back(range);
  }
  return changed;
}

}  // namespace stipple
