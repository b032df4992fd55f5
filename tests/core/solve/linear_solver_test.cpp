#include "core/solve/linear_solver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "tests/support/cancel_after.h"
#include "tests/support/grid_laplacian.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class EveryMethod : public testing::TestWithParam<SolverMethod> {};
std::string nameOfMethod(const testing::TestParamInfo<SolverMethod>& info) {
  constexpr std::array kNames = {"Auto", "ConjugateGradient", "Cholesky"};
  return kNames[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(LinearSolver, EveryMethod,
                         testing::Values(SolverMethod::kAuto, SolverMethod::kConjugateGradient,
                                         SolverMethod::kCholesky),
                         nameOfMethod);

TEST_P(EveryMethod, SolvesEigenvectorsAndReportsTheResidual) {
  const LinearSolver solver(shiftedGridLaplacian(30, 20, 0.2), {.method = GetParam(), .tolerance = 1e-11});
  Eigen::MatrixXd u(600, 2), b(600, 2);
  u.col(0) = gridEigenvector(30, 20, 1, 1);
  u.col(1) = gridEigenvector(30, 20, 0, 4);
  b.col(0) = (0.2 + gridEigenvalue(30, 20, 1, 1)) * u.col(0);
  b.col(1) = (0.2 + gridEigenvalue(30, 20, 0, 4)) * u.col(1);
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(600, 2);
  const SolveReport report = solver.solve(b, x);
  EXPECT_LT((x - u).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(report.residual, 1e-10);
}

TEST_P(EveryMethod, UpdateChangesTheMatrix) {
  LinearSolver solver(shiftedGridLaplacian(10, 10, 1.0), {.method = GetParam(), .tolerance = 1e-12});
  solver.update(shiftedGridLaplacian(10, 10, 3.0));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(100);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(100);
  solver.solve(ones, x);
  EXPECT_LT((x - ones / 3).cwiseAbs().maxCoeff(), 1e-10);
}

TEST_P(EveryMethod, RefusesWhatIsNotANumber) {
  const LinearSolver solver(shiftedGridLaplacian(5, 5, 1.0), {.method = GetParam()});
  Eigen::VectorXd b = Eigen::VectorXd::Ones(25), x = Eigen::VectorXd::Zero(25);
  b[17] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { solver.solve(b, x); },
              ThrowsMessage<SolverError>(HasSubstr("right-hand side[17] is nan")));
  SparseMatrix broken = shiftedGridLaplacian(5, 5, 1.0);
  broken.coeffRef(3, 4) = std::numeric_limits<double>::infinity();
  EXPECT_THAT([&] { LinearSolver(broken, {.method = GetParam()}); },
              ThrowsMessage<SolverError>(HasSubstr("matrix entry (3, 4) is inf")));
  EXPECT_THAT([&] { solver.solve(Eigen::VectorXd::Ones(7), x); },
              ThrowsMessage<InvalidInput>(HasSubstr("do not fit a matrix with 25 rows")));
}

TEST_P(EveryMethod, RefusesAnIndefiniteMatrix) {
  const auto solve = [&] {
    const LinearSolver solver(shiftedGridLaplacian(20, 20, -1.0), {.method = GetParam()});
    Eigen::VectorXd x = Eigen::VectorXd::Zero(400);
    solver.solve(gridEigenvector(20, 20, 1, 0), x);
  };
  EXPECT_THAT(solve, ThrowsMessage<SolverError>(HasSubstr("not positive definite")));
}

TEST_P(EveryMethod, StopsWhenAsked) {
  const CancelAfter cancel(0);
  const LinearSolver solver(shiftedGridLaplacian(5, 5, 1.0), {.method = GetParam()});
  Eigen::VectorXd x = Eigen::VectorXd::Zero(25);
  EXPECT_THROW(solver.solve(Eigen::VectorXd::Ones(25), x, &cancel), Cancelled);
}

TEST_P(EveryMethod, AnEmptySystemIsSolved) {
  const LinearSolver solver(SparseMatrix(0, 0), {.method = GetParam()});
  Eigen::VectorXd x(0);
  EXPECT_EQ(solver.solve(Eigen::VectorXd(0), x).iterations, 0);
}

TEST(LinearSolver, ChoosesByCost) {
  const SparseMatrix easy = shiftedGridLaplacian(200, 200, 5.0);
  const SparseMatrix hard = shiftedGridLaplacian(200, 200, 1e-5);
  EXPECT_EQ(chooseMethod(easy, {.expectedSolves = 1}), SolverMethod::kConjugateGradient);
  EXPECT_EQ(chooseMethod(hard, {.expectedSolves = 20}), SolverMethod::kCholesky);
  EXPECT_EQ(chooseMethod(hard, {.method = SolverMethod::kConjugateGradient, .expectedSolves = 20}),
            SolverMethod::kConjugateGradient);
}

}  // namespace
}  // namespace stipple
