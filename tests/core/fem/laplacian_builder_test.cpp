#include "core/fem/laplacian_builder.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace stipple {
namespace {

Eigen::MatrixXd sumOf(Index rows, const std::vector<WeightedEdge>& edges) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(rows, rows);
  for (const WeightedEdge& e : edges) {
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(rows);
    difference[e.i] = 1;
    difference[e.j] = -1;
    sum += e.weight * difference * difference.transpose();
  }
  return sum;
}

double leastEigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()[0];
}

// Edges between random rows, some of them twice; a fifth of the rows has none below 0.
std::vector<WeightedEdge> randomEdges(Index rows) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> weight(-1, 1);
  std::vector<WeightedEdge> edges;
  while (edges.size() < 6 * rows) {
    const auto i = static_cast<Index>(random() % rows), j = static_cast<Index>(random() % rows);
    const double w = weight(random);
    if (i != j) edges.push_back({i, j, std::min(i, j) < rows / 5 ? std::abs(w) : w});
  }
  return edges;
}

constexpr Index kRows = 60;

TEST(LaplacianBuilder, IsTheSumOfItsEdges) {
  const std::vector<WeightedEdge> edges = randomEdges(kRows);
  EXPECT_LT((buildLaplacian(kRows, std::vector(edges)).toDense() - sumOf(kRows, edges)).norm(), 1e-12);
}

TEST(LaplacianBuilder, WithoutNegativeWeightsItIsSemidefinite) {
  const SparseMatrix before = buildLaplacian(kRows, randomEdges(kRows));
  ASSERT_LT(leastEigenvalue(before.toDense()), -0.1);
  SparseMatrix after = before;
  dropNegativeWeights(after);

  std::vector<WeightedEdge> positive;
  for (Index i = 0; i < kRows; ++i) {
    for (Index j = 0; j < i; ++j) {
      if (before.coeff(i, j) < 0) positive.push_back({i, j, -before.coeff(i, j)});
    }
  }
  EXPECT_LT((after.toDense() - sumOf(kRows, positive)).norm(), 1e-12);
  EXPECT_GT(leastEigenvalue(after.toDense()), -1e-12);
}

TEST(LaplacianBuilder, RowsWithoutNegativeWeightsKeepTheirBits) {
  const SparseMatrix before = buildLaplacian(kRows, randomEdges(kRows));
  SparseMatrix after = before;
  dropNegativeWeights(after);
  int kept = 0;
  for (Index i = 0; i < kRows; ++i) {
    bool isKept = true;
    for (Index j = 0; j < kRows; ++j) isKept = isKept && (i == j || before.coeff(i, j) <= 0);
    for (Index j = 0; isKept && j < kRows; ++j) EXPECT_EQ(after.coeff(i, j), before.coeff(i, j));
    kept += isKept;
  }
  EXPECT_GE(kept, 5);
}

}  // namespace
}  // namespace stipple
