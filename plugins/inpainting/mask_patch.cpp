#include "plugins/inpainting/mask_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>

#include "core/geometry/neighborhoods.h"

namespace stipple {

namespace {

// On an even surface the 24 nearest of a point lie within 2.8 mean spacings. Five times that: 64 neighbors of
// a neighbor of a rim (7 spacings), room for fans that agree only together with others, and around what the
// light is found on (7 spacings) what its relief is measured against.
constexpr int kNearest = 24;
constexpr float kRadiusInNearest = 5;
// Masked points whose neighborhoods decide how far to look.
constexpr std::size_t kSample = 512;

using Cell = Eigen::Vector3i;
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    const auto mixed = static_cast<std::uint64_t>(c.x()) * 0x9e3779b97f4a7c15u ^
                       static_cast<std::uint64_t>(c.y()) * 0xc2b2ae3d27d4eb4fu ^
                       static_cast<std::uint64_t>(c.z()) * 0x165667b19e3779f9u;
    return mixed ^ (mixed >> 29);
  }
};

// Cells of half the radius that hold a masked point, and two layers around them.
class WidenedMask {
 public:
  WidenedMask(std::span<const Eigen::Vector3f> positions, std::span<const Index> masked, float radius)
      : corner_(positions[masked.front()]), size_(radius / 2) {
    std::unordered_set<Cell, CellHash> held;
    for (const Index row : masked) held.insert(cellOf(positions[row]));
    for (const Cell& cell : held) {
      for (int n = 0; n < 125; ++n) cells_.insert(cell + Cell(n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2));
    }
    for (const Cell& cell : cells_) box_.extend(cell);
  }
  bool contains(const Eigen::Vector3f& position) const {
    const Cell cell = cellOf(position);
    return box_.contains(cell) && cells_.contains(cell);
  }

 private:
  // What lies farther than cells can be counted is in a cell at the end.
  Cell cellOf(const Eigen::Vector3f& position) const {
    const Eigen::Array3f scaled = ((position - corner_) / size_).array().floor();
    return scaled.max(-1e9f).min(1e9f).cast<int>();
  }

  Eigen::Vector3f corner_;
  float size_;
  std::unordered_set<Cell, CellHash> cells_;
  Eigen::AlignedBox3i box_;
};

std::vector<Index> rowsWithin(const PointSet& whole, std::span<const Index> masked, float radius,
                              const Progress* progress) {
  constexpr std::size_t kBlock = 1 << 15;
  const std::span<const Eigen::Vector3f> positions = whole.positions();
  const WidenedMask mask(positions, masked, radius);
  std::vector<std::vector<Index>> parts((positions.size() + kBlock - 1) / kBlock);
  parallelFor(
      positions.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          if (mask.contains(positions[row])) parts[begin / kBlock].push_back(static_cast<Index>(row));
        }
      },
      progress);
  std::vector<Index> rows;
  for (const std::vector<Index>& part : parts) rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

PointSet takeRows(const PointSet& whole, std::span<const Index> rows) {
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(rows.size());
  for (const Index row : rows) positions.push_back(whole.positions()[row]);
  return PointSet(std::move(positions));
}

// How far nineteen of twenty masked points of the sample have to go for their nearest neighbors in the patch.
float wideNeighborhood(const MaskPatch& patch, std::span<const Index> masked) {
  const Sites sites = weldAndOrder(patch.points.positions());
  const NeighborSearch search(sites.positions, kNearest);
  std::vector<Index> neighbors;
  std::vector<float> squared;
  std::vector<float> reaches;
  const std::size_t stride = (masked.size() + kSample - 1) / kSample;
  for (std::size_t m = 0; m < masked.size(); m += stride) {
    const auto place = std::ranges::lower_bound(patch.rows, masked[m]) - patch.rows.begin();
    search.findNearest(sites.siteOfPoint[static_cast<std::size_t>(place)], kNearest, neighbors, squared);
    if (neighbors.size() < kNearest) return std::numeric_limits<float>::infinity();
    reaches.push_back(squared.back());
  }
  const auto place = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() * 19 / 20);
  std::nth_element(reaches.begin(), place, reaches.end());
  return std::sqrt(*place);
}

}  // namespace

MaskPatch wholePatch(const PointSet& whole) {
  MaskPatch patch{.rows = std::vector<Index>(whole.size()), .points = PointSet()};
  std::iota(patch.rows.begin(), patch.rows.end(), 0u);
  patch.points = takeRows(whole, patch.rows);
  patch.points.setTriangles(whole.triangles());
  return patch;
}

MaskPatch cutPatch(const PointSet& whole, std::span<const Index> masked, const Progress* progress) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : whole.positions()) box.extend(position);
  // About 18 spacings of an even scan: more than is needed there.
  float radius = 18 * box.diagonal().norm() / std::sqrt(static_cast<float>(whole.size()));
  const bool isMostMasked = 2 * masked.size() > whole.size();
  while (!isMostMasked && radius > 0 && radius < box.diagonal().norm()) {
    MaskPatch patch{.rows = rowsWithin(whole, masked, radius, progress), .points = PointSet()};
    patch.points = takeRows(whole, patch.rows);
    const float needed = kRadiusInNearest * wideNeighborhood(patch, masked);
    if (needed > 0 && needed <= radius) {
      patch.rows = rowsWithin(whole, masked, needed, progress);
      patch.points = takeRows(whole, patch.rows);
      return patch;
    }
    radius = std::isfinite(needed) ? std::max(1.2f * needed, 2 * radius) : 2 * radius;
  }
  return wholePatch(whole);
}

}  // namespace stipple
