#include "render/hierarchy/closedness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace stipple {

namespace {

constexpr std::size_t kGrain = 1 << 14;
// Of the box of cells without its rim, in all and for each leaf, and along an axis.
constexpr double kMostCells = 3e7, kMostCellsOfLeaf = 200, kMostAlong = 2048;
// Cells that a disc may pass through on average: where most are that much larger than the median, nothing is
// known.
constexpr double kMostCellsOfDisc = 100;
// Cells that a line from a disc goes on through what is filled, in half cells.
constexpr int kSteps = 16;
// Backs look at each other where their normals make at least about 110 degrees; both are known by octant.
constexpr float kOpposite = -0.3f;
// Least share of the leaves with an inside behind them: of the scans that are closed 0.9 to 1 have one, of
// those that leak 0.05 at most.
constexpr double kLeastEnclosed = 0.9;
// Most leaves whose normals seem to be flipped, and whose backs seem to be seen: points in narrow folds, of
// rims and of tips. Triangles exclude flipped normals and single sheets already.
struct Exceptions {
  double flipped, bare;
};
constexpr Exceptions kOfPoints{0, 1e-3}, kOfTriangles{1e-2, 1e-2};
// A node this many of its radii away counts as one place in the winding number.
constexpr float kFar = 2, kFarWithoutCone = 8;

// Cells of a box around all leaves: the octants of the normals of discs that pass through each, and whether
// one comes there from outside without passing through a disc. A rim of one cell is outside.
class Cells {
 public:
  static constexpr std::uint16_t kOctants = 0xff, kOutside = 0x100;

  Cells(const glm::vec3& low, const glm::vec3& high, float side) : low_(low - side), side_(side) {
    const glm::vec3 counts = (high - low) / side;
    for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<int>(counts[axis]) + 3;
    cells_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], 0);
  }

  float side() const { return side_; }
  std::uint16_t at(const glm::vec3& place) const { return cells_[index(cellOf(place))]; }

  // All cells that the square around the disc passes through.
  void mark(const Splat& disc, const glm::vec3& n) {
    const glm::vec3 reach = disc.radius * glm::sqrt(glm::max(glm::vec3(1) - n * n, glm::vec3(0)));
    const std::array<int, 3> first = cellOf(disc.center() - reach), last = cellOf(disc.center() + reach);
    const float thickness = 0.5f * side_ * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int x = first[0]; x <= last[0]; ++x) {
          if (std::abs(glm::dot(n, centerOf(x, y, z) - disc.center())) <= thickness)
            add(index({x, y, z}), octantOf(n));
        }
      }
    }
  }

  void floodFromOutside(const Progress* progress);

 private:
  static std::uint16_t octantOf(const glm::vec3& n) {
    return static_cast<std::uint16_t>(1 << ((n.x < 0) | (n.y < 0) << 1 | (n.z < 0) << 2));
  }
  void add(std::size_t cell, std::uint16_t octant) {
    const std::atomic_ref<std::uint16_t> held(cells_[cell]);
    if (!(held.load(std::memory_order_relaxed) & octant)) held.fetch_or(octant, std::memory_order_relaxed);
  }
  std::size_t index(const std::array<int, 3>& c) const {
    return (static_cast<std::size_t>(c[2]) * size_[1] + c[1]) * size_[0] + c[0];
  }
  std::array<int, 3> cellOf(const glm::vec3& place) const {
    std::array<int, 3> cell{};
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = std::clamp(static_cast<int>((place[axis] - low_[axis]) / side_), 0, size_[axis] - 1);
    return cell;
  }
  glm::vec3 centerOf(int x, int y, int z) const { return low_ + side_ * (glm::vec3(x, y, z) + 0.5f); }

  glm::vec3 low_;
  float side_;
  std::array<int, 3> size_{};
  std::vector<std::uint16_t> cells_;
};

// Runs along rows: each is filled at once, and asks those beside it.
void Cells::floodFromOutside(const Progress* progress) {
  constexpr std::size_t kBetweenLooks = 1 << 12;
  const std::size_t row = size_[0], layer = row * size_[1], last = cells_.size();
  std::vector<std::size_t> open{0};
  for (std::size_t runs = 0; !open.empty(); ++runs) {
    if (progress && runs % kBetweenLooks == 0) progress->throwIfCancelled();
    const std::size_t cell = open.back();
    open.pop_back();
    if (cells_[cell] != 0) continue;
    const std::size_t rowBegin = cell - cell % row, rowEnd = rowBegin + row;
    std::size_t begin = cell, end = cell + 1;
    while (begin > rowBegin && cells_[begin - 1] == 0) --begin;
    while (end < rowEnd && cells_[end] == 0) ++end;
    std::fill(cells_.begin() + static_cast<std::ptrdiff_t>(begin),
              cells_.begin() + static_cast<std::ptrdiff_t>(end), kOutside);
    const auto askRow = [&](std::size_t from) {
      for (std::size_t i = 0; i < end - begin; ++i) {
        if (cells_[from + i] == 0 && (i == 0 || cells_[from + i - 1] != 0)) open.push_back(from + i);
      }
    };
    const std::size_t y = cell % layer / row;
    if (y > 0) askRow(begin - row);
    if (y + 1 < static_cast<std::size_t>(size_[1])) askRow(begin + row);
    if (cell >= layer) askRow(begin - layer);
    if (cell + layer < last) askRow(begin + layer);
  }
}

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};
};

Box boxOf(std::span<const Splat> leaves) {
  Box box;
  for (const Splat& leaf : leaves) {
    box.low = glm::min(box.low, leaf.center() - leaf.radius);
    box.high = glm::max(box.high, leaf.center() + leaf.radius);
  }
  return box;
}

float medianRadius(std::span<const Splat> leaves) {
  const std::size_t step = std::max<std::size_t>(leaves.size() / 10'000, 1);
  std::vector<float> radii;
  for (std::size_t i = 0; i < leaves.size(); i += step) radii.push_back(leaves[i].radius);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

// 0 where the leaves are no surface, or too different in size.
float sideOfCells(const glm::vec3& low, const glm::vec3& high, std::span<const Splat> leaves) {
  const glm::dvec3 extent = glm::dvec3(high) - glm::dvec3(low);
  const double volume = extent.x * extent.y * extent.z;
  if (!(volume > 0) || !std::isfinite(volume)) return 0;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const auto count = static_cast<double>(leaves.size());
  const double most = std::min(kMostCells, kMostCellsOfLeaf * count);
  const double side = std::max({static_cast<double>(medianRadius(leaves)), std::cbrt(volume / most),
                                longest / std::min(kMostAlong, count)});
  double marked = 0;
  for (const Splat& leaf : leaves) marked += std::pow(2 * leaf.radius / side + 1, 2);
  return marked <= kMostCellsOfDisc * count ? static_cast<float>(side) : 0;
}

// What a line meets that leaves a disc along `way`: kNothing where it is not out of the discs after some
// cells.
enum class Met { kNothing, kInside, kOutside };
struct Look {
  Met met = Met::kNothing;
  std::uint16_t octants = 0;  // of the normals in all cells on the way
};

Look look(const Cells& cells, const glm::vec3& from, const glm::vec3& way) {
  Look seen;
  for (int step = 0; step <= kSteps; ++step) {
    const std::uint16_t cell = cells.at(from + (0.5f * cells.side() * static_cast<float>(step)) * way);
    if ((cell & Cells::kOctants) == 0) {
      seen.met = cell == 0 ? Met::kInside : Met::kOutside;
      return seen;
    }
    seen.octants |= cell;
  }
  return seen;
}

bool hasOpposite(std::uint16_t octants, const glm::vec3& n) {
  for (int octant = 0; octant < 8; ++octant) {
    const glm::vec3 diagonal(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    if (octants >> octant & 1 && glm::dot(diagonal, n) < kOpposite * 1.7320508f) return true;
  }
  return false;
}

// Leaves with a space inside behind them; with that before them and the outside behind; whose backs can be
// seen.
struct Tally {
  std::atomic<std::size_t> inside{0}, flipped{0}, bare{0};
};

void tally(const Cells& cells, std::span<const Splat> leaves, Tally& sum) {
  std::size_t inside = 0, flipped = 0, bare = 0;
  for (const Splat& leaf : leaves) {
    const glm::vec3 n = unpackNormal(leaf.shape);
    const Look behind = look(cells, leaf.center(), -n);
    inside += behind.met == Met::kInside;
    if (behind.met != Met::kOutside) continue;
    flipped += look(cells, leaf.center(), n).met == Met::kInside;
    bare += !hasOpposite(behind.octants, n);
  }
  sum.inside += inside;
  sum.flipped += flipped;
  sum.bare += bare;
}

// Whether all points' normals lie on the side of their triangles' mean normal.
bool agreeWithTriangles(const PointSet& points, const Hierarchy& hierarchy) {
  const auto positions = points.positions();
  std::vector<Eigen::Vector3f> means(points.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : points.triangles()) {
    const Eigen::Vector3f normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    for (const Index corner : {a, b, c}) means[corner] += normal;
  }
  for (Index point = 0; point < points.size(); ++point) {
    const glm::vec3 n = unpackNormal(hierarchy.splats()[hierarchy.slotOfPoint[point]].shape);
    if (means[point].dot(Eigen::Vector3f(n.x, n.y, n.z)) < 0) return false;
  }
  return true;
}

// Whether the backs of the discs look into spaces that are not reachable from outside, or, where a part is
// too thin to have one, at the backs of others.
bool encloseTheirBacks(const Hierarchy& hierarchy, const Exceptions& most, const Progress* progress) {
  const std::span<const Splat> leaves = hierarchy.splats().first(hierarchy.leafCount());
  if (leaves.empty()) return false;
  const auto [low, high] = boxOf(leaves);
  const float side = sideOfCells(low, high, leaves);
  if (!(side > 0)) return false;
  Cells cells(low, high, side);
  const auto forLeaves = [&](const auto& body) {
    parallelFor(
        leaves.size(), kGrain,
        [&](std::size_t begin, std::size_t end) { body(leaves.subspan(begin, end - begin)); }, progress);
  };
  forLeaves([&](std::span<const Splat> part) {
    for (const Splat& leaf : part) cells.mark(leaf, unpackNormal(leaf.shape));
  });
  cells.floodFromOutside(progress);
  Tally sum;
  forLeaves([&](std::span<const Splat> part) { tally(cells, part, sum); });
  const auto count = static_cast<double>(leaves.size());
  return static_cast<double>(sum.flipped) <= most.flipped * count &&
         static_cast<double>(sum.bare) <= most.bare * count &&
         static_cast<double>(sum.inside) >= kLeastEnclosed * count;
}

}  // namespace

bool areClosed(std::span<const Triangle> triangles, Index points) {
  // Edges by their lower corner, compressed rows: the other corner, and whether they go up or down.
  std::vector<std::size_t> begins(points + std::size_t{1}, 0);
  std::vector<std::uint8_t> isUsed(points, 0);
  const auto forEdges = [&](const auto& body) {
    for (const Triangle& t : triangles) {
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      for (int side = 0; side < 3; ++side) body(t[side], t[(side + 1) % 3]);
    }
  };
  forEdges([&](Index a, Index b) {
    ++begins[std::min(a, b) + 1];
    isUsed[a] = 1;
  });
  if (std::ranges::count(isUsed, 1) != points) return false;
  for (Index point = 0; point < points; ++point) begins[point + 1] += begins[point];
  std::vector<std::uint64_t> edges(begins.back());
  std::vector<std::size_t> ends(begins.begin(), begins.end() - 1);
  forEdges([&](Index a, Index b) {
    edges[ends[std::min(a, b)]++] = std::uint64_t{std::max(a, b)} << 1 | static_cast<std::uint64_t>(a < b);
  });
  for (Index point = 0; point < points; ++point) {
    const std::span<std::uint64_t> around(edges.data() + begins[point], edges.data() + begins[point + 1]);
    std::ranges::sort(around);
    if (around.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const bool isPaired = (around[i] & 1) == i % 2 && around[i] >> 1 == around[i - i % 2] >> 1;
      if (!isPaired || (i > 0 && around[i] == around[i - 1])) return false;
    }
  }
  return points > 0;
}

bool isClosedAndOriented(const PointSet& points, const Hierarchy& hierarchy, const Progress* progress) {
  const bool hasTriangles = !points.triangles().empty();
  if (hasTriangles &&
      !(areClosed(points.triangles(), points.size()) && agreeWithTriangles(points, hierarchy)))
    return false;
  return encloseTheirBacks(hierarchy, hasTriangles ? kOfTriangles : kOfPoints, progress);
}

// Sum of solid angles over 4 pi (Barill et al. 2018, without their higher terms).
bool isInside(const Hierarchy& hierarchy, const glm::vec3& place) {
  if (hierarchy.leafCount() == 0) return false;
  constexpr float kPi = 3.14159265f;
  struct Node {
    int level;
    Index inLevel;
  };
  std::vector<Node> open{{hierarchy.levelCount() - 1, 0}};
  float angle = 0;
  while (!open.empty()) {
    const auto [level, inLevel] = open.back();
    open.pop_back();
    const Index node = hierarchy.levelBegin(level) + inLevel;
    const Splat& splat = hierarchy.splats()[node];
    const glm::vec3 towards = splat.center() - place;
    const float distance = glm::length(towards);
    const bool hasCone = level == 0 || hierarchy.bound(node).cosine > 0;
    if (level == 0 || distance > (hasCone ? kFar : kFarWithoutCone) * hierarchy.bound(node).radius) {
      const float cosine = glm::dot(unpackNormal(splat.shape), towards) / std::max(distance, 1e-30f);
      const float share = areaOf(splat) / std::max(distance * distance, 1e-30f);
      angle += cosine * std::min(share, 2 * kPi);
      continue;
    }
    const Index first = inLevel * Hierarchy::kArity;
    const Index end = std::min(first + Hierarchy::kArity, hierarchy.levelSize(level - 1));
    for (Index child = first; child < end; ++child) open.push_back({level - 1, child});
  }
  return angle > 2 * kPi;
}

}  // namespace stipple
