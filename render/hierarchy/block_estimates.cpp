#include "render/hierarchy/block_estimates.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace stipple {

namespace {

// A block has a rim: distances within it are that much longer than those to all points.
constexpr float kRim = 0.85f;
constexpr int kRank = 3;

using Block = std::array<Eigen::Vector3f, kLeavesOfBlock>;
using Lanes = Eigen::Array<float, kLeavesOfBlock, 1>;

// Median over the points of the squared distance to the third nearest of the others; 0 below four points. One
// lane a point: each goes through all others and keeps the four smallest distances, the first of which is its
// own 0.
float squaredSpacing(const Block& points, int count) {
  if (count <= kRank) return 0;
  Lanes x, y, z;
  for (int i = 0; i < static_cast<int>(kLeavesOfBlock); ++i) {
    const Eigen::Vector3f& p = points[std::min(i, count - 1)];
    x[i] = p.x();
    y[i] = p.y();
    z[i] = p.z();
  }
  std::array<Lanes, kRank + 1> nearest;
  nearest.fill(Lanes::Constant(std::numeric_limits<float>::max()));
  for (int j = 0; j < count; ++j) {
    Lanes d = (x - x[j]).square() + (y - y[j]).square() + (z - z[j]).square();
    for (Lanes& held : nearest) {
      const Lanes less = held.min(d);
      d = held.max(d);
      held = less;
    }
  }
  Lanes ranked = nearest.back();
  std::nth_element(ranked.data(), ranked.data() + count / 2, ranked.data() + count);
  return ranked[count / 2];
}

Eigen::Vector3f fitNormal(const Block& x, int count) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (int i = 0; i < count; ++i) mean += x[i] - x[0];
  mean /= static_cast<float>(count);
  Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f d = x[i] - x[0] - mean;
    products.noalias() += d * d.transpose();
  }
  const float scale = products.trace();
  if (!(scale > 0) || !std::isfinite(scale)) return Eigen::Vector3f::UnitZ();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(products / scale);
  return solver.eigenvectors().col(0);
}

int takeBlock(std::span<const PlacedPoint> leaves, std::size_t block, Block& x) {
  const std::size_t first = block * kLeavesOfBlock;
  const int count = static_cast<int>(std::min<std::size_t>(kLeavesOfBlock, leaves.size() - first));
  for (int i = 0; i < count; ++i) x[i] = leaves[first + i].position;
  return count;
}

}  // namespace

std::vector<float> estimateBlockSpacings(std::span<const PlacedPoint> leaves, const Progress* progress) {
  const std::size_t blocks = (leaves.size() + kLeavesOfBlock - 1) / kLeavesOfBlock;
  std::vector<float> spacings(blocks);
  parallelFor(
      blocks, 1024,
      [&](std::size_t begin, std::size_t end) {
        Block x;
        for (std::size_t block = begin; block < end; ++block)
          spacings[block] = kRim * std::sqrt(squaredSpacing(x, takeBlock(leaves, block, x)));
      },
      progress);
  // What has no distances of its own (few points, copies of one place) is like its neighbor.
  for (std::size_t block = 1; block < blocks; ++block) {
    if (!(spacings[block] > 0)) spacings[block] = spacings[block - 1];
  }
  for (std::size_t block = blocks; block > 1; --block) {
    if (!(spacings[block - 2] > 0)) spacings[block - 2] = spacings[block - 1];
  }
  return spacings;
}

Eigen::Vector3f fitBlockNormal(std::span<const PlacedPoint> leaves, std::size_t block) {
  Block x;
  const int count = takeBlock(leaves, block, x);
  return fitNormal(x, count);
}

}  // namespace stipple
