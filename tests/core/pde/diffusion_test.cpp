#include "core/pde/diffusion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/error.h"
#include "tests/support/grid_laplacian.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const SolverOptions kExact = {.tolerance = 1e-13};

TEST(DiffusionStepper, EigenvectorsDecayByTheImplicitFactor) {
  const double tau = 0.7;
  const std::vector<double> mass(500, 1.0);
  const DiffusionStepper stepper(gridLaplacian(25, 20), mass,
                                 {.timeStep = tau, .held = {}, .solver = kExact});
  Eigen::MatrixXd u(500, 2);
  u.col(0) = gridEigenvector(25, 20, 2, 3);
  u.col(1) = gridEigenvector(25, 20, 0, 1);
  const Eigen::MatrixXd start = u;
  for (int step = 0; step < 5; ++step) stepper.step(u);
  const double fast = std::pow(1 + tau * gridEigenvalue(25, 20, 2, 3), -5);
  const double slow = std::pow(1 + tau * gridEigenvalue(25, 20, 0, 1), -5);
  EXPECT_LT((u.col(0) - fast * start.col(0)).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((u.col(1) - slow * start.col(1)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(DiffusionStepper, KeepsTheTotalAndAddsTheSource) {
  std::vector<double> mass(144);
  for (std::size_t i = 0; i < mass.size(); ++i) mass[i] = 1 + 0.5 * std::sin(static_cast<double>(i));
  const Eigen::Map<const Eigen::VectorXd> weights(mass.data(), 144);
  const DiffusionStepper stepper(gridLaplacian(12, 12), mass, {.timeStep = 3, .held = {}, .solver = kExact});
  Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(144, 0, 1);
  const double total = weights.dot(u);
  stepper.step(u);
  EXPECT_NEAR(weights.dot(u), total, 1e-9 * total);
  stepper.step(u, Eigen::VectorXd::Constant(144, 0.25));
  EXPECT_NEAR(weights.dot(u), total + 3 * 0.25 * weights.sum(), 1e-9 * total);
}

TEST(DiffusionStepper, HeldRowsStayAndTheRestTendsToTheLine) {
  // A strip with its ends held: the steady state is linear.
  const int length = 11;
  std::vector<double> mass(length, 1.0);
  const DiffusionStepper stepper(gridLaplacian(length, 1), mass,
                                 {.timeStep = 1e6, .held = {0, 10}, .solver = kExact});
  Eigen::VectorXd u = Eigen::VectorXd::Zero(length);
  u[10] = 5;
  for (int step = 0; step < 4; ++step) stepper.step(u);
  for (int i = 0; i < length; ++i) EXPECT_NEAR(u[i], 0.5 * i, 1e-8);
}

TEST(DiffusionStepper, RefusesWhatMakesNoSense) {
  std::vector<double> mass(9, 1.0);
  EXPECT_THAT([&] { diffusionMatrix(gridLaplacian(3, 3), mass, -1); },
              ThrowsMessage<InvalidInput>(HasSubstr("time step is -1")));
  mass[4] = 0;
  EXPECT_THAT([&] { diffusionMatrix(gridLaplacian(3, 3), mass, 1); },
              ThrowsMessage<InvalidInput>(HasSubstr("mass[4] is 0")));
  mass.pop_back();
  EXPECT_THAT([&] { diffusionMatrix(gridLaplacian(3, 3), mass, 1); },
              ThrowsMessage<InvalidInput>(HasSubstr("8 masses")));
}

TEST(EllipticSolver, ContinuesALinearFunction) {
  // Interior of a grid from its rim: x + 2 y is harmonic on the grid.
  const int width = 14, height = 9;
  std::vector<Index> inner;
  Eigen::VectorXd truth(width * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      truth[y * width + x] = x + 2 * y;
      if (x > 0 && y > 0 && x < width - 1 && y < height - 1) inner.push_back(y * width + x);
    }
  }
  const EllipticSolver solver(gridLaplacian(width, height), inner, kExact);
  Eigen::VectorXd u = truth;
  for (const Index row : inner) u[row] = 0;
  solver.solve(u);
  EXPECT_LT((u - truth).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE(solver.unreached().empty());
}

TEST(EllipticSolver, TakesAnotherStiffness) {
  // A chain of springs from 0 to 1: the first as stiff as the second, then three times as stiff, then cut.
  std::vector<WeightedEdge> even{{0, 1, 1.0}, {1, 2, 1.0}}, uneven{{0, 1, 3.0}, {1, 2, 1.0}},
      cut{{0, 2, 1.0}};
  EllipticSolver solver(buildLaplacian(3, std::move(even)), std::vector<Index>{1}, kExact);
  Eigen::VectorXd u = Eigen::Vector3d(0, 7, 1);
  solver.solve(u);
  EXPECT_NEAR(u[1], 0.5, 1e-12);
  solver.update(buildLaplacian(3, std::move(uneven)));
  solver.solve(u);
  EXPECT_NEAR(u[1], 0.25, 1e-12);
  solver.update(buildLaplacian(3, std::move(cut)));
  EXPECT_EQ(solver.unreached(), std::vector<Index>{1});
}

TEST(EllipticSolver, LeavesWhatNoKnownRowTouches) {
  // Two strips without a coupling; the second is wholly unknown.
  SparseMatrix both(8, 8);
  std::vector<Eigen::Triplet<double>> entries;
  const SparseMatrix strip = gridLaplacian(4, 1);
  for (int row = 0; row < 4; ++row) {
    for (SparseMatrix::InnerIterator e(strip, row); e; ++e) {
      entries.emplace_back(row, e.col(), e.value());
      entries.emplace_back(row + 4, e.col() + 4, e.value());
    }
  }
  both.setFromTriplets(entries.begin(), entries.end());
  const std::vector<Index> unknown = {1, 2, 4, 5, 6, 7};
  const EllipticSolver solver(both, unknown, kExact);
  EXPECT_THAT(solver.unreached(), ElementsAre(4, 5, 6, 7));
  Eigen::VectorXd u(8);
  u << 0, 9, 9, 3, 7, 8, 7, 8;
  solver.solve(u);
  EXPECT_NEAR(u[1], 1, 1e-10);
  EXPECT_NEAR(u[2], 2, 1e-10);
  EXPECT_EQ(u.tail(4), Eigen::Vector4d(7, 8, 7, 8));
}

}  // namespace
}  // namespace stipple
