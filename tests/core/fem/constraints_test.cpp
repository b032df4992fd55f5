#include "core/fem/constraints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/error.h"
#include "tests/support/grid_laplacian.h"

namespace stipple {
namespace {

using testing::ElementsAre;

TEST(DirichletConstraints, TheReducedSystemIsTheSchurBlockOfTheWhole) {
  const SparseMatrix a = shiftedGridLaplacian(6, 4, 0.5);
  const std::vector<Index> held = {7, 3, 20, 7};
  const DirichletConstraints constraints(a, held);
  EXPECT_THAT(constraints.heldRows(), ElementsAre(3, 7, 20));
  EXPECT_EQ(constraints.freeRows().size(), 21u);

  // Choose u, compute b = A u: the free part of u must come back from the reduced system.
  Eigen::MatrixXd u(24, 2);
  for (int i = 0; i < 48; ++i) u.data()[i] = std::sin(0.9 * i);
  const Eigen::MatrixXd b = a * u;
  const Eigen::MatrixXd x = Eigen::MatrixXd(constraints.freeMatrix()).ldlt().solve(constraints.reduce(b, u));
  EXPECT_LT((x - constraints.gather(u)).cwiseAbs().maxCoeff(), 1e-12);

  Eigen::MatrixXd filled = u;
  for (const Index row : constraints.freeRows()) filled.row(row).setConstant(99);
  constraints.scatter(x, filled);
  EXPECT_LT((filled - u).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DirichletConstraints, KeepsSymmetry) {
  const std::vector<Index> held = {0, 11, 12};
  const DirichletConstraints constraints(gridLaplacian(5, 5), held);
  const Eigen::MatrixXd reduced(constraints.freeMatrix());
  EXPECT_EQ(reduced, reduced.transpose());
}

TEST(DirichletConstraints, NothingHeldIsTheMatrixItself) {
  const SparseMatrix a = shiftedGridLaplacian(4, 4, 1);
  const DirichletConstraints constraints(a, {});
  EXPECT_EQ(Eigen::MatrixXd(constraints.freeMatrix()), Eigen::MatrixXd(a));
  EXPECT_EQ(constraints.reduce(Eigen::VectorXd::Ones(16), Eigen::VectorXd::Zero(16)),
            Eigen::VectorXd::Ones(16));
}

TEST(DirichletConstraints, ARowThatIsNoneIsRefused) {
  const std::vector<Index> held = {25};
  EXPECT_THROW(DirichletConstraints(gridLaplacian(5, 5), held), InvalidInput);
}

}  // namespace
}  // namespace stipple
