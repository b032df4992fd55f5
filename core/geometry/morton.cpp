#include "core/geometry/morton.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/parallel.h"

namespace stipple {

namespace {

// Puts two zeros between the lower 21 bits.
std::uint64_t spread(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffff;
  v = (v | v << 16) & 0x1f0000ff0000ff;
  v = (v | v << 8) & 0x100f00f00f00f00f;
  v = (v | v << 4) & 0x10c30c30c30c30c3;
  return (v | v << 2) & 0x1249249249249249;
}

std::uint32_t compact(std::uint64_t v) {
  v &= 0x1249249249249249;
  v = (v | v >> 2) & 0x10c30c30c30c30c3;
  v = (v | v >> 4) & 0x100f00f00f00f00f;
  v = (v | v >> 8) & 0x1f0000ff0000ff;
  v = (v | v >> 16) & 0x1f00000000ffff;
  return static_cast<std::uint32_t>((v | v >> 32) & 0x1fffff);
}

}  // namespace

std::uint64_t mortonEncode(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return spread(x) | spread(y) << 1 | spread(z) << 2;
}

void mortonDecode(std::uint64_t code, std::uint32_t& x, std::uint32_t& y, std::uint32_t& z) {
  x = compact(code);
  y = compact(code >> 1);
  z = compact(code >> 2);
}

std::uint64_t MortonLattice::codeOf(const Eigen::Vector3f& position) const {
  constexpr float kLast = (1 << kBits) - 1;
  const Eigen::Vector3f cell = ((position - corner) / cellSize).cwiseMax(0.f).cwiseMin(kLast);
  return mortonEncode(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y()),
                      static_cast<std::uint32_t>(cell.z()));
}

MortonLattice fitMortonLattice(std::span<const Eigen::Vector3f> positions) {
  MortonLattice lattice;
  if (positions.empty()) return lattice;
  constexpr std::size_t kBlock = 1 << 18;
  const std::size_t blocks = (positions.size() + kBlock - 1) / kBlock;
  std::vector<Eigen::Vector3f> lows(blocks), highs(blocks);
  parallelFor(positions.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    Eigen::Vector3f low = positions[begin], high = low;
    for (const Eigen::Vector3f& p : positions.subspan(begin, end - begin)) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    lows[begin / kBlock] = low;
    highs[begin / kBlock] = high;
  });
  Eigen::Vector3f low = lows[0], high = highs[0];
  for (std::size_t block = 1; block < blocks; ++block) {
    low = low.cwiseMin(lows[block]);
    high = high.cwiseMax(highs[block]);
  }
  lattice.corner = low;
  // Divided before the difference, so that a box of the largest floats does not overflow.
  const float extent = (high / (1 << MortonLattice::kBits) - low / (1 << MortonLattice::kBits)).maxCoeff();
  lattice.cellSize = std::max(extent * 1.000001f, std::numeric_limits<float>::min());
  return lattice;
}

}  // namespace stipple
