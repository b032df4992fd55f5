#include "core/solve/conjugate_gradient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tests/support/cancel_after.h"
#include "tests/support/grid_laplacian.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ConjugateGradient, SolvesAnEigenvectorExactly) {
  const SparseMatrix matrix = shiftedGridLaplacian(40, 30, 0.1);
  const Eigen::VectorXd u = gridEigenvector(40, 30, 3, 2);
  const Eigen::VectorXd b = (0.1 + gridEigenvalue(40, 30, 3, 2)) * u;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  const SolveReport report = solveByConjugateGradient(matrix, b, x, {.tolerance = 1e-12});
  EXPECT_LT((x - u).norm(), 1e-10 * u.norm());
  EXPECT_GT(report.iterations, 0);
  EXPECT_LT(report.residual, 2e-12);
}

TEST(ConjugateGradient, ColumnsMatchTheDenseSolution) {
  const SparseMatrix matrix = shiftedGridLaplacian(12, 9, 0.3);
  Eigen::MatrixXd b(matrix.rows(), 7);
  for (int i = 0; i < b.size(); ++i) b.data()[i] = std::sin(1.7 * i);
  b.col(4).setZero();
  const Eigen::MatrixXd expected = Eigen::MatrixXd(matrix).ldlt().solve(b);
  Eigen::MatrixXd x = Eigen::MatrixXd::Constant(b.rows(), b.cols(), 2.0);
  solveByConjugateGradient(matrix, b, x, {.tolerance = 1e-12});
  EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(x.col(4), Eigen::VectorXd::Zero(b.rows())) << "nothing on the right gives exactly nothing";
}

TEST(ConjugateGradient, SameBitsForAnyNumberOfThreadsAndCompanions) {
  const SparseMatrix matrix = shiftedGridLaplacian(200, 150, 0.01);
  Eigen::MatrixXd b(matrix.rows(), 3);
  for (int i = 0; i < b.size(); ++i) b.data()[i] = std::cos(0.37 * i) + (i % 11);
  const auto solve = [&](int threads, int columns) {
    const ThreadLimit limit(threads);
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(b.rows(), columns);
    solveByConjugateGradient(matrix, b.leftCols(columns), x, {});
    return x;
  };
  const Eigen::MatrixXd reference = solve(1, 3);
  EXPECT_EQ(solve(2, 3), reference);
  EXPECT_EQ(solve(5, 3), reference);
}

TEST(ConjugateGradient, AGoodGuessCostsFewerIterations) {
  const SparseMatrix matrix = shiftedGridLaplacian(60, 60, 0.001);
  const Eigen::VectorXd b = gridEigenvector(60, 60, 1, 5) + gridEigenvector(60, 60, 7, 0);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  const int cold = solveByConjugateGradient(matrix, b, x, {}).iterations;
  const int warm = solveByConjugateGradient(matrix, b, x, {}).iterations;
  EXPECT_GT(cold, 1);
  EXPECT_LE(warm, 1);
}

TEST(ConjugateGradient, SaysWhatWentWrong) {
  const Eigen::VectorXd b = gridEigenvector(20, 20, 3, 3);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  EXPECT_THAT([&] { solveByConjugateGradient(shiftedGridLaplacian(20, 20, -0.5), b, x, {}); },
              ThrowsMessage<SolverError>(HasSubstr("not positive definite")));
  EXPECT_THAT([&] { solveByConjugateGradient(shiftedGridLaplacian(20, 20, -9), b, x, {}); },
              ThrowsMessage<SolverError>(HasSubstr("entry (0, 0) is -7")));
  x.setZero();
  const Eigen::VectorXd rough = Eigen::VectorXd::LinSpaced(400, -3, 8).array().sin();
  EXPECT_THAT(
      [&] { solveByConjugateGradient(shiftedGridLaplacian(20, 20, 1e-6), rough, x, {.maxIterations = 3}); },
      ThrowsMessage<SolverError>(HasSubstr("did not converge: 3 iterations")));
}

TEST(ConjugateGradient, StopsWhenAsked) {
  const CancelAfter cancel(2);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(2500, -3, 8).array().sin();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  EXPECT_THROW(solveByConjugateGradient(shiftedGridLaplacian(50, 50, 1e-6), b, x, {}, &cancel), Cancelled);
}

}  // namespace
}  // namespace stipple
