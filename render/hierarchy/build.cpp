#include "render/hierarchy/build.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/hierarchy/block_estimates.h"
#include "render/hierarchy/refit.h"

namespace stipple {

namespace {

// A whole subtree of leaves, which stays in the cache until it is aggregated.
constexpr int kBlockLevels = 7;
constexpr std::size_t kGrain = 1 << (2 * kBlockLevels);
// Leaves between asking for memory and using it.
constexpr Index kAhead = 24;
// Disc of a leaf of a block over the spacing: random points leave one of a thousand places bare.
constexpr float kBlockRadius = 1.8f;
// The same for a radius that came with the points: drawn discs overlap so that they just blend.
constexpr float kGivenRadius = 1.3f;
constexpr Rgba8 kGray{200, 200, 200, 0};

class LeafFiller {
 public:
  LeafFiller(const LeafAttributes& leaves, std::span<const PlacedPoint> slots, const Progress* progress)
      : leaves_(leaves), slots_(slots), least_(leastRadius()) {
    if (leaves.radii.empty()) spacings_ = estimateBlockSpacings(slots, progress);
    if (leaves.normals.empty()) fitNormals(progress);
  }

  // Files come in any order: what a leaf reads is asked for before it is its turn.
  void prefetch(Index slot) const {
    const Index point = slots_[slot].point;
    if (!leaves_.normals.empty()) __builtin_prefetch(&leaves_.normals[point]);
    if (!leaves_.colors.empty()) __builtin_prefetch(&leaves_.colors[point]);
    if (!leaves_.radii.empty()) __builtin_prefetch(&leaves_.radii[point]);
    if (!leaves_.areas.empty()) __builtin_prefetch(&leaves_.areas[point]);
  }

  Splat fill(Index slot) const {
    const auto& [p, point] = slots_[slot];
    Splat splat;
    splat.x = p.x();
    splat.y = p.y();
    splat.z = p.z();
    float side = 0;
    if (leaves_.radii.empty()) {
      side = std::max(spacings_[slot / kLeavesOfBlock], least_);
      splat.radius = kBlockRadius * side;
    } else {
      splat.radius = std::max(leaves_.radii[point], least_);
      side = leaves_.areas.empty() ? splat.radius / kGivenRadius : std::sqrt(leaves_.areas[point]);
    }
    splat.shape = packNormal(normalOf(slot, point)) | ratioBits(side / splat.radius);
    splat.color = leaves_.colors.empty() ? kGray : leaves_.colors[point];
    return splat;
  }

 private:
  // All leaves of blocks have one ratio.
  std::uint32_t ratioBits(float ratio) const {
    return leaves_.radii.empty() ? blockRatio_ : packShape({0, 0, 1}, ratio) & 0xff000000;
  }

  void fitNormals(const Progress* progress) {
    normals_.resize((slots_.size() + kLeavesOfBlock - 1) / kLeavesOfBlock);
    parallelFor(
        normals_.size(), kGrain / kLeavesOfBlock,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t block = begin; block < end; ++block)
            normals_[block] = fitBlockNormal(slots_, block);
        },
        progress);
  }

  glm::vec3 normalOf(Index slot, Index point) const {
    Eigen::Vector3f n = Eigen::Vector3f::Zero();
    if (!leaves_.normals.empty()) n = leaves_.normals[point];
    if (n.isZero(0))
      n = normals_.empty() ? fitBlockNormal(slots_, slot / kLeavesOfBlock) : normals_[slot / kLeavesOfBlock];
    return {n.x(), n.y(), n.z()};
  }

  // Copies of one place must not vanish: a millionth of the extent, or of the coordinates.
  float leastRadius() const {
    if (leaves_.positions.empty()) return 0;
    std::vector<Eigen::AlignedBox3f> boxes((leaves_.positions.size() + kGrain - 1) / kGrain);
    parallelFor(leaves_.positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      Eigen::AlignedBox3f box;
      for (const Eigen::Vector3f& p : leaves_.positions.subspan(begin, end - begin)) box.extend(p);
      boxes[begin / kGrain] = box;
    });
    Eigen::AlignedBox3f all;
    for (const Eigen::AlignedBox3f& box : boxes) all.extend(box);
    const float extent = all.sizes().maxCoeff(), farthest = all.max().cwiseMax(-all.min()).maxCoeff();
    return std::max({1e-6f * extent, 1e-7f * farthest, 1e-12f});
  }

  const LeafAttributes& leaves_;
  std::span<const PlacedPoint> slots_;
  float least_;
  std::uint32_t blockRatio_ = packShape({0, 0, 1}, 1 / kBlockRadius) & 0xff000000;
  std::vector<float> spacings_;
  std::vector<Eigen::Vector3f> normals_;
};

}  // namespace

Hierarchy buildHierarchy(const LeafAttributes& leaves, LeafOrder order, const Progress* progress) {
  const auto count = static_cast<Index>(leaves.positions.size());
  Hierarchy hierarchy(count);
  hierarchy.pointOfSlot.resize(count);
  hierarchy.slotOfPoint.resize(count);
  const RawVector<PlacedPoint> slots = orderLeaves(leaves.positions, order, progress);
  const LeafFiller filler(leaves, slots, progress);
  const std::span<Splat> splats = hierarchy.editSplats();
  parallelFor(
      count, kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (auto slot = static_cast<Index>(begin); slot < end; ++slot) {
          if (slot + kAhead < count) {
            filler.prefetch(slot + kAhead);
            __builtin_prefetch(&hierarchy.slotOfPoint[slots[slot + kAhead].point], 1);
          }
          const Index point = slots[slot].point;
          hierarchy.pointOfSlot[slot] = point;
          hierarchy.slotOfPoint[point] = slot;
          splats[slot] = filler.fill(slot);
        }
        refitLeaves(hierarchy, begin, end, kBlockLevels);
      },
      progress);
  refitAll(hierarchy, progress, kBlockLevels + 1);
  return hierarchy;
}

}  // namespace stipple
