#include "core/solve/cholesky.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <thread>

#include "tests/support/cancel_after.h"
#include "tests/support/grid_laplacian.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Eigen::MatrixXd waves(Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd b(rows, columns);
  for (int i = 0; i < b.size(); ++i) b.data()[i] = std::sin(1.7 * i) + 0.1;
  return b;
}

TEST(CholeskyFactor, MatchesEigensFactorization) {
  const SparseMatrix matrix = shiftedGridLaplacian(70, 50, 0.01);
  const Eigen::MatrixXd b = waves(matrix.rows(), 3);
  CholeskyFactor factor;
  factor.factorize(matrix);
  Eigen::MatrixXd x(b.rows(), 3);
  factor.solve(b, x);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> reference{Eigen::SparseMatrix<double>(matrix)};
  EXPECT_LT((x - reference.solve(b)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(CholeskyFactor, TakesNewValuesAndNewPatterns) {
  CholeskyFactor factor;
  for (const SparseMatrix& matrix : {shiftedGridLaplacian(9, 7, 0.5), shiftedGridLaplacian(9, 7, 4.0),
                                     shiftedGridLaplacian(7, 9, 1.0), shiftedGridLaplacian(4, 4, 1.0)}) {
    factor.factorize(matrix);
    const Eigen::MatrixXd b = waves(matrix.rows(), 2);
    Eigen::MatrixXd x(b.rows(), 2);
    factor.solve(b, x);
    EXPECT_LT((Eigen::MatrixXd(matrix) * x - b).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(CholeskyFactor, SaysWhereAMatrixIsNotPositiveDefinite) {
  SparseMatrix matrix = shiftedGridLaplacian(6, 5, 1.0);
  matrix.coeffRef(13, 13) = -2;
  CholeskyFactor factor;
  EXPECT_THAT([&] { factor.factorize(matrix); },
              ThrowsMessage<SolverError>(HasSubstr("broke down at row 13")));
  matrix.coeffRef(13, 13) = 6;
  EXPECT_NO_THROW(factor.factorize(matrix)) << "usable again after a failure";
}

TEST(CholeskyFactor, IsSharedBetweenThreads) {
  const SparseMatrix matrix = shiftedGridLaplacian(40, 40, 0.2);
  CholeskyFactor factor;
  factor.factorize(matrix);
  const Eigen::MatrixXd b = waves(matrix.rows(), 1);
  Eigen::MatrixXd first(b.rows(), 1), second(b.rows(), 1);
  {
    const std::jthread other([&] { factor.solve(b, second); });
    factor.solve(b, first);
  }
  EXPECT_EQ(first, second);
}

TEST(CholeskyFactor, TwoFactorsAtOnceAreBothRight) {
  const SparseMatrix matrix = shiftedGridLaplacian(150, 150, 0.1);
  const Eigen::MatrixXd b = waves(matrix.rows(), 1);
  const auto residualOfFresh = [&] {
    double worst = 0;
    for (int round = 0; round < 5; ++round) {
      CholeskyFactor factor;
      factor.factorize(matrix);
      Eigen::MatrixXd x(b.rows(), 1);
      factor.solve(b, x);
      worst = std::max(worst, (matrix * x - b).cwiseAbs().maxCoeff());
    }
    return worst;
  };
  double other = 1;
  {
    const std::jthread thread([&] { other = residualOfFresh(); });
    EXPECT_LT(residualOfFresh(), 1e-11);
  }
  EXPECT_LT(other, 1e-11);
}

TEST(CholeskyFactor, AFactorizationIsAbandonedOnRequest) {
  const SparseMatrix matrix = shiftedGridLaplacian(400, 400, 0.1);
  auto factor = std::make_shared<CholeskyFactor>();
  const CancelAfter cancel(0);
  EXPECT_THROW(factorizeInterruptibly(factor, matrix, &cancel), Cancelled);
  const Progress patient;
  const SparseMatrix small = shiftedGridLaplacian(150, 150, 0.1);
  factorizeInterruptibly(factor, small, &patient);
  const Eigen::MatrixXd b = waves(small.rows(), 1);
  Eigen::MatrixXd x(b.rows(), 1);
  factor->solve(b, x);
  EXPECT_LT((small * x - b).cwiseAbs().maxCoeff(), 1e-11);
}

}  // namespace
}  // namespace stipple
