#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "core/parallel.h"

namespace stipple {

/// Compressed rows, full symmetric pattern (both triangles stored), columns ascending.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// Adds weight (e_i - e_j)(e_i - e_j)^T to a matrix: -weight off the diagonal, +weight on it.
struct WeightedEdge {
  Index i, j;
  double weight;
};

/// Sum of the edges: symmetric, rows sum to 0, every diagonal entry stored. The order of the edges decides
/// the order of the additions. The edges are consumed.
SparseMatrix buildLaplacian(Index rows, std::vector<WeightedEdge>&& edges);

/// Makes such a matrix semidefinite, and steps with it keep to the range of the values: weights below 0
/// (off-diagonals above 0), as schemes paper and mesh have at obtuse angles, become 0, and rows still sum to
/// 0. Linear precision is lost there (Wardetzky et al. 2007); rows without such weights keep their bits.
void dropNegativeWeights(SparseMatrix& laplacian);

/// The edges that emit(begin, end, edges) appends for blocks of rows, in the order of the blocks.
template <class Emit>
std::vector<WeightedEdge> collectEdges(Index rows, Emit&& emit, const Progress* progress) {
  constexpr std::size_t kBlock = 4096;
  std::vector<std::vector<WeightedEdge>> parts((rows + kBlock - 1) / kBlock);
  parallelFor(
      rows, kBlock,
      [&](std::size_t begin, std::size_t end) {
        emit(static_cast<Index>(begin), static_cast<Index>(end), parts[begin / kBlock]);
      },
      progress);
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<WeightedEdge> edges;
  edges.reserve(total);
  for (auto& part : parts) {
    edges.insert(edges.end(), part.begin(), part.end());
    std::vector<WeightedEdge>().swap(part);
  }
  return edges;
}

}  // namespace stipple
