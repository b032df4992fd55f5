#include "core/geometry/cell_index.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace stipple {

namespace {

constexpr std::uint64_t kEmpty = std::numeric_limits<std::uint64_t>::max();

std::uint64_t hashOf(std::uint64_t cell) { return (cell * 0x9e3779b97f4a7c15u) >> 20; }

// Finest level at which occupied cells hold `pointsPerCell` points on average. Two successive codes lie in different
// cells of exactly the levels below that of their highest differing bit.
int levelFor(std::span<const std::uint64_t> codes, double pointsPerCell) {
  std::array<std::size_t, MortonLattice::kBits + 1> splits{};
  for (std::size_t i = 1; i < codes.size(); ++i) {
    const std::uint64_t difference = codes[i] ^ codes[i - 1];
    if (difference != 0) ++splits[(63 - std::countl_zero(difference)) / 3];
  }
  std::size_t occupied = 1;
  for (int level = MortonLattice::kBits - 1; level >= 0; --level) {
    occupied += splits[level];
    if (static_cast<double>(codes.size()) < pointsPerCell * static_cast<double>(occupied)) return level + 1;
  }
  return 0;
}

}  // namespace

CellIndex::CellIndex(std::span<const Eigen::Vector3f> positions, double pointsPerCell)
    : lattice_(fitMortonLattice(positions)), codes_(positions.size()) {
  parallelFor(codes_.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) codes_[i] = lattice_.codeOf(positions[i]);
  });
  level_ = std::min(levelFor(codes_, pointsPerCell), MortonLattice::kBits - 1);
  tables_ = {buildTable(level_), buildTable(level_ + 1)};
}

CellIndex::Table CellIndex::buildTable(int level) const {
  const int shift = 3 * level;
  std::size_t occupied = 0;
  for (std::size_t i = 0; i < codes_.size(); ++i) occupied += i == 0 || codes_[i] >> shift != codes_[i - 1] >> shift;
  Table table;
  const std::size_t slots = std::bit_ceil(2 * occupied + 1);
  table.mask = slots - 1;
  table.cells.assign(slots, kEmpty);
  table.ranges.resize(slots);
  for (std::size_t begin = 0; begin < codes_.size();) {
    const std::uint64_t cell = codes_[begin] >> shift;
    std::size_t end = begin + 1;
    while (end < codes_.size() && codes_[end] >> shift == cell) ++end;
    std::uint64_t slot = hashOf(cell) & table.mask;
    while (table.cells[slot] != kEmpty) slot = (slot + 1) & table.mask;
    table.cells[slot] = cell;
    table.ranges[slot] = {static_cast<Index>(begin), static_cast<Index>(end)};
    begin = end;
  }
  return table;
}

IndexRange CellIndex::Table::find(std::uint64_t cell) const {
  for (std::uint64_t slot = hashOf(cell) & mask;; slot = (slot + 1) & mask) {
    if (cells[slot] == cell) return ranges[slot];
    if (cells[slot] == kEmpty) return {};
  }
}

IndexRange CellIndex::pointsIn(std::uint64_t cell, int level) const {
  if (level == level_ || level == level_ + 1) return tables_[level - level_].find(cell);
  IndexRange within{0, static_cast<Index>(codes_.size())};
  if (level < level_) {
    within = tables_[0].find(cell >> (3 * (level_ - level)));
    if (within.size() == 0) return {};
  }
  const auto first = codes_.begin() + within.begin, last = codes_.begin() + within.end;
  const auto begin = std::lower_bound(first, last, cell << (3 * level));
  const auto end = std::lower_bound(begin, last, (cell + 1) << (3 * level));
  return {static_cast<Index>(begin - codes_.begin()), static_cast<Index>(end - codes_.begin())};
}

CellIndex::Block CellIndex::blockAround(std::uint64_t cell, int level) const {
  Block block;
  std::uint32_t x, y, z;
  mortonDecode(cell, x, y, z);
  const std::uint32_t limit = 1u << (MortonLattice::kBits - level);
  for (std::uint32_t dz = 0; dz < 3; ++dz) {
    for (std::uint32_t dy = 0; dy < 3; ++dy) {
      for (std::uint32_t dx = 0; dx < 3; ++dx) {
        // Unsigned wrap-around below 0 fails the comparison too.
        const std::uint32_t cx = x + dx - 1, cy = y + dy - 1, cz = z + dz - 1;
        if (cx >= limit || cy >= limit || cz >= limit) continue;
        const IndexRange range = pointsIn(mortonEncode(cx, cy, cz), level);
        if (range.size() == 0) continue;
        block.ranges[static_cast<std::size_t>(block.count++)] = range;
        block.points += range.size();
      }
    }
  }
  return block;
}

float CellIndex::reachOf(const Eigen::Vector3f& position, std::uint64_t cell, int level) const {
  std::uint32_t c[3];
  mortonDecode(cell, c[0], c[1], c[2]);
  const float size = cellSize(level);
  const auto last = static_cast<float>(1u << (MortonLattice::kBits - level));
  float reach = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float inCells = (position[axis] - lattice_.corner[axis]) / size;
    const auto low = static_cast<float>(c[axis]) - 1, high = static_cast<float>(c[axis]) + 2;
    // Nothing lies beyond the faces of the lattice.
    if (low > 0) reach = std::min(reach, inCells - low);
    if (high < last) reach = std::min(reach, high - inCells);
  }
  // The lattice coordinates are rounded to floats: keep clear of their last bits.
  return (reach - 2.5e-7f * last) * size;
}

}  // namespace stipple
