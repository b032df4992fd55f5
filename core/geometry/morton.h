#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

namespace stipple {

/// Cubic lattice of 2^21 cells an axis over the bounding box; a cell's Morton code interleaves its coordinates, so
/// that the cells of every coarser power-of-two lattice are contiguous ranges of codes.
struct MortonLattice {
  static constexpr int kBits = 21;
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
  float cellSize = 1;  ///< of the finest level, > 0

  std::uint64_t codeOf(const Eigen::Vector3f& position) const;
};

MortonLattice fitMortonLattice(std::span<const Eigen::Vector3f> positions);

/// Interleaves 21 bits a coordinate, x lowest.
std::uint64_t mortonEncode(std::uint32_t x, std::uint32_t y, std::uint32_t z);
void mortonDecode(std::uint64_t code, std::uint32_t& x, std::uint32_t& y, std::uint32_t& z);

}  // namespace stipple
