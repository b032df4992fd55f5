#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/morton.h"
#include "core/parallel.h"

namespace stipple {

/// Half-open range of rows.
struct IndexRange {
  Index begin = 0, end = 0;
  Index size() const { return end - begin; }
};

/// Finds the points of a lattice cell, for positions in Morton order. Level l has cells of 2^l lattice units; two
/// neighboring levels are hashed, the others are found by bisection of the sorted codes.
class CellIndex {
 public:
  /// Hashes the finest level whose occupied cells hold `pointsPerCell` or more on average, and the one above.
  CellIndex(std::span<const Eigen::Vector3f> positions, double pointsPerCell);

  int hashedLevel() const { return level_; }
  float cellSize(int level) const { return lattice_.cellSize * static_cast<float>(1u << level); }
  std::uint64_t cellOf(Index row, int level) const { return codes_[row] >> (3 * level); }
  IndexRange pointsIn(std::uint64_t cell, int level) const;

  /// The up to 27 occupied ranges of the cell and those around it, and the distance from `position` (in the cell) to
  /// the nearest face of that block beyond which points are missing.
  struct Block {
    std::array<IndexRange, 27> ranges;
    int count = 0;
    std::size_t points = 0;
  };
  Block blockAround(std::uint64_t cell, int level) const;
  float reachOf(const Eigen::Vector3f& position, std::uint64_t cell, int level) const;

 private:
  struct Table {
    std::vector<std::uint64_t> cells;
    std::vector<IndexRange> ranges;
    std::uint64_t mask = 0;
    IndexRange find(std::uint64_t cell) const;
  };
  Table buildTable(int level) const;

  MortonLattice lattice_;
  std::vector<std::uint64_t> codes_;
  int level_ = 0;
  std::array<Table, 2> tables_;
};

}  // namespace stipple
