#include "app/view/displayed_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/hierarchy/build.h"
#include "render/hierarchy/closedness.h"
#include "render/hierarchy/sort_leaves.h"
#include "render/hierarchy/splat_radii.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 1 << 14;

void placeLeaf(Splat& splat, const Eigen::Vector3f& position) {
  splat.x = position.x();
  splat.y = position.y();
  splat.z = position.z();
}

void turnLeaf(Splat& splat, const Eigen::Vector3f& normal) {
  if (normal.isZero(0) || !normal.allFinite()) return;
  splat.shape = (splat.shape & 0xff000000) | packNormal({normal.x(), normal.y(), normal.z()});
}

std::vector<NodeRange> everything(const Hierarchy& hierarchy) {
  return {{.begin = 0, .end = hierarchy.nodeCount()}};
}

}  // namespace

Extent measureExtent(const PointSet& points) {
  const std::span<const Eigen::Vector3f> positions = points.positions();
  if (positions.empty()) return {};
  const std::size_t blocks = (positions.size() + kGrain - 1) / kGrain;
  std::vector<Eigen::AlignedBox3f> boxes(blocks);
  parallelFor(positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) boxes[begin / kGrain].extend(positions[i]);
  });
  Eigen::AlignedBox3f box;
  for (const Eigen::AlignedBox3f& part : boxes) box.extend(part);
  const Eigen::Vector3f center = box.center();
  std::vector<float> farthest(blocks, 0);
  parallelFor(positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      farthest[begin / kGrain] = std::max(farthest[begin / kGrain], (positions[i] - center).squaredNorm());
  });
  const float radius = std::sqrt(*std::ranges::max_element(farthest));
  const glm::vec3 middle(center.x(), center.y(), center.z());
  // As if the points lay on a sphere of that size.
  const float spacing = radius * std::sqrt(4 * 3.14159f / static_cast<float>(points.size()));
  return radius > 0 ? Extent{{middle, radius}, spacing} : Extent{{middle, 1}, 0.1f};
}

Hierarchy refineHierarchy(const PointSet& points, std::span<const Rgba8> colors, const Progress* progress) {
  const SurfaceEstimate surface = estimateSurface(points, progress);
  Hierarchy refined = buildHierarchy({.positions = points.positions(),
                                      .radii = surface.radii,
                                      .areas = surface.areas,
                                      .normals = surface.normals,
                                      .colors = colors},
                                     LeafOrder::kKd, progress);
  refined.isClosedAndOriented = isClosedAndOriented(points, refined, progress);
  return refined;
}

DisplayedSurface::DisplayedSurface(const PointSet& points, std::span<const Rgba8> colors,
                                   const Progress* progress) {
  const std::vector<Eigen::Vector3f> normals = normalsOfFile(points);
  hierarchy_ = buildHierarchy(
      {.positions = points.positions(), .radii = {}, .areas = {}, .normals = normals, .colors = colors},
      LeafOrder::kMorton, progress);
  isSorted_ = size() == 0;
  hasBlockNormals_ = normals.empty();
}

std::vector<NodeRange> DisplayedSurface::sortNext() {
  const std::vector<NodeRange> changed =
      sortLeaves(hierarchy_, sortedBlocks_++, {.fitsNormals = hasBlockNormals_});
  isSorted_ = std::uint64_t{sortedBlocks_} * kSortedLeaves >= size();
  return changed;
}

void DisplayedSurface::askClosedness(const PointSet& points, const Progress* progress) {
  hierarchy_.isClosedAndOriented = isClosedAndOriented(points, hierarchy_, progress);
}

void DisplayedSurface::adopt(Hierarchy refined, const std::optional<std::vector<Index>>& recolored) {
  const Hierarchy before = std::move(hierarchy_);
  hierarchy_ = std::move(refined);
  isSorted_ = true;
  const auto colorOf = [&](Index point) { return before.splats()[before.slotOfPoint[point]].color; };
  std::vector<Rgba8> colors(recolored ? recolored->size() : before.leafCount());
  if (recolored) {
    std::ranges::transform(*recolored, colors.begin(), colorOf);
    recolor(*recolored, colors);
    return;
  }
  parallelFor(colors.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t point = begin; point < end; ++point) colors[point] = colorOf(static_cast<Index>(point));
  });
  recolorAll(colors);
}

std::vector<NodeRange> DisplayedSurface::recolor(std::span<const Index> rows, std::span<const Rgba8> colors) {
  const std::span<Splat> splats = hierarchy_.editSplats();
  std::vector<Index> slots(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    slots[i] = hierarchy_.slotOfPoint[rows[i]];
    splats[slots[i]].color = colors[i];
  }
  return refit(hierarchy_, slots);
}

std::vector<NodeRange> DisplayedSurface::recolorAll(std::span<const Rgba8> colors) {
  const std::span<Splat> splats = hierarchy_.editSplats();
  parallelFor(size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      splats[slot].color = colors[hierarchy_.pointOfSlot[slot]];
  });
  refitAll(hierarchy_);
  return everything(hierarchy_);
}

std::vector<NodeRange> DisplayedSurface::move(const PointSet& points) {
  const std::span<Splat> splats = hierarchy_.editSplats();
  const std::span<const Eigen::Vector3f> positions = points.positions();
  const std::vector<Eigen::Vector3f> normals = normalsOfFile(points);
  parallelFor(size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Index point = hierarchy_.pointOfSlot[slot];
      placeLeaf(splats[slot], positions[point]);
      if (!normals.empty()) turnLeaf(splats[slot], normals[point]);
    }
  });
  hierarchy_.isClosedAndOriented = false;  // not known any more
  refitAll(hierarchy_);
  return everything(hierarchy_);
}

}  // namespace stipple
