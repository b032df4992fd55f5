#include "plugins/texture_synthesis/pair_diffusion.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/geometry/discretization.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

struct Problem {
  Discretization discretization;
  SparseMatrix stiffness;
  double spacing = 0;
  std::vector<float> right;  // of two species, side by side
};

Problem makeProblem(int count) {
  Progress progress;
  Problem problem;
  problem.discretization = discretize(PointSet(shapes::randomSphere(count)), {}, progress);
  problem.stiffness = assembleStiffness(problem.discretization);
  problem.spacing = std::sqrt(4 * std::numbers::pi / count);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> uniform;
  for (int i = 0; i < count; ++i) {
    problem.right.push_back(uniform(random));
    problem.right.push_back(uniform(random));
  }
  return problem;
}

Eigen::VectorXd solveExactly(const Problem& problem, const PairTerms& terms, int lane) {
  const auto which = static_cast<std::size_t>(lane);
  const auto size = static_cast<Eigen::Index>(problem.discretization.size());
  Eigen::VectorXd b(size);
  SparseMatrix matrix = terms.stiffness[which] * problem.stiffness;
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const double mass = problem.discretization.mass[row];
    matrix.coeffRef(i, i) += terms.mass[which] * mass;
    b[i] = mass * static_cast<double>(problem.right[2 * row + which]);
  }
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(b);
}

// L2 distance to the exact solution, relative to that of the right-hand side: to the change of a step.
double relativeError(const Problem& problem, const Eigen::VectorXd& exact, std::span<const float> u,
                     int lane) {
  const auto which = static_cast<std::size_t>(lane);
  double error = 0, change = 0;
  for (std::size_t row = 0; row < problem.discretization.size(); ++row) {
    const double mass = problem.discretization.mass[row], value = exact[static_cast<Eigen::Index>(row)];
    error += mass * std::pow(static_cast<double>(u[2 * row + which]) - value, 2);
    change += mass * std::pow(static_cast<double>(problem.right[2 * row + which]) - value, 2);
  }
  return std::sqrt(error / change);
}

// One solve for `u`, which holds the first guess.
PairDiffusion::Outcome solve(PairDiffusion& diffusion, const PairTerms& terms, std::span<const float> right,
                             std::vector<float>& u) {
  const std::size_t room = 2 * diffusion.paddedSites();
  std::vector<float> before = u, after(room), written(room);
  before.resize(room);
  const PairDiffusion::Outcome outcome =
      diffusion.solve(diffusion.plan(terms), {.right = written, .before = before, .after = after},
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = 2 * begin; i < 2 * end; ++i) written[i] = right[i];
                      });
  after.resize(u.size());
  u = after;
  return outcome;
}

TEST(PairDiffusion, ApproachesTheExactSolutionOfBothSpecies) {
  const Problem problem = makeProblem(3000);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  const double h2 = problem.spacing * problem.spacing;
  const PairTerms terms = {.mass = {1, 1.2}, .stiffness = {0.5 * h2, 2 * h2}};
  const Eigen::VectorXd exact[] = {solveExactly(problem, terms, 0), solveExactly(problem, terms, 1)};
  std::vector<float> u = problem.right;
  EXPECT_GT(solve(diffusion, terms, problem.right, u).sweeps, 0);
  for (int lane = 0; lane < 2; ++lane) EXPECT_LT(relativeError(problem, exact[lane], u, lane), 0.2) << lane;
  // What is left of the residual is worked off by later calls.
  for (int call = 0; call < 6; ++call) solve(diffusion, terms, problem.right, u);
  for (int lane = 0; lane < 2; ++lane) EXPECT_LT(relativeError(problem, exact[lane], u, lane), 1e-5) << lane;
}

TEST(PairDiffusion, DoesTheSweepsOfItsPlanAsADenseMatrixDoes) {
  // Not a multiple of a slice, and rows of different lengths.
  const Problem problem = makeProblem(149);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  const double h2 = problem.spacing * problem.spacing;
  const PairTerms terms = {.mass = {1, 1.2}, .stiffness = {0.3 * h2, 3 * h2}};
  const PairDiffusion::Plan plan = diffusion.plan(terms);
  std::vector<float> u(problem.right.rbegin(), problem.right.rend());
  const std::vector<float> guess = u;
  const PairDiffusion::Outcome outcome = solve(diffusion, terms, problem.right, u);
  for (std::size_t lane = 0; lane < 2; ++lane) {
    EXPECT_EQ(outcome.sweeps, plan.sweeps[lane].size());
    Eigen::VectorXd right(149), now(149);
    for (Eigen::Index i = 0; i < 149; ++i) {
      const auto place = 2 * static_cast<std::size_t>(i) + lane;
      right[i] = static_cast<double>(problem.right[place]);
      now[i] = static_cast<double>(guess[place]);
    }
    const Eigen::VectorXd mass = Eigen::VectorXd::Map(problem.discretization.mass.data(), 149), first = now;
    Eigen::MatrixXd matrix = terms.stiffness[lane] * Eigen::MatrixXd(problem.stiffness);
    matrix.diagonal() += terms.mass[lane] * mass;
    Eigen::VectorXd before = now;
    for (const Sweep& sweep : plan.sweeps[lane]) {
      const Eigen::VectorXd residual = mass.cwiseProduct(right) - matrix * now;
      const Eigen::VectorXd after =
          now + sweep.momentum * (now - before) + sweep.gain * residual.cwiseQuotient(matrix.diagonal());
      before = now;
      now = after;
    }
    now = now.cwiseMax(0);
    for (Eigen::Index i = 0; i < 149; ++i) {
      EXPECT_NEAR(u[2 * static_cast<std::size_t>(i) + lane], now[i], 1e-5);
    }
    EXPECT_NEAR(outcome.squaredChange[lane], (now - first).squaredNorm(), 1e-3);
  }
}

TEST(PairDiffusion, SweepsLeaveLittleOfAUniformChange) {
  const Problem problem = makeProblem(3000);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  const std::vector<float> zero(6000, 0);
  int before = 0;
  for (const double share : {0.01, 1.0, 100.0}) {
    const double tau = share * problem.spacing * problem.spacing;
    std::vector<float> u(6000, 1);
    const int sweeps = solve(diffusion, {.mass = {1, 1}, .stiffness = {tau, tau}}, zero, u).sweeps;
    EXPECT_GE(sweeps, before);
    before = sweeps;
    double left = 0, area = 0;
    for (std::size_t row = 0; row < 3000; ++row) {
      left += problem.discretization.mass[row] * std::pow(static_cast<double>(u[2 * row]), 2);
      area += problem.discretization.mass[row];
    }
    EXPECT_LT(std::sqrt(left / area), 0.05) << share;
  }
}

TEST(PairDiffusion, SameBitsOnEveryInstructionSet) {
  const Problem problem = makeProblem(501);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  const double h2 = problem.spacing * problem.spacing;
  const PairTerms terms = {.mass = {1, 1.2}, .stiffness = {0.3 * h2, 3 * h2}};
  const std::vector<float> guess(problem.right.rbegin(), problem.right.rend());
  std::vector<float> best = guess;
  solve(diffusion, terms, problem.right, best);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    std::vector<float> u = guess;
    solve(diffusion, terms, problem.right, u);
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_EQ(u, best) << hwy::TargetName(target);
  }
}

TEST(PairDiffusion, ConstantsStayAsTheyAre) {
  const Problem problem = makeProblem(500);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  std::vector<float> constant(1000, 4);
  for (std::size_t i = 1; i < constant.size(); i += 2) constant[i] = 0.3f;
  std::vector<float> u = constant;
  EXPECT_EQ(solve(diffusion, {.mass = {1, 1}, .stiffness = {1, 1}}, constant, u).sweeps, 0);
  EXPECT_EQ(u, constant);
}

TEST(PairDiffusion, AnIndefiniteMatrixIsRefused) {
  const Problem problem = makeProblem(500);
  const SparseMatrix negative = -problem.stiffness;
  PairDiffusion diffusion(negative, problem.discretization.mass, problem.spacing);
  std::vector<float> u = problem.right;
  const double tau = 10 * problem.spacing * problem.spacing;
  EXPECT_THROW(solve(diffusion, {.mass = {1, 1}, .stiffness = {tau, tau}}, problem.right, u), SolverError);
}

TEST(PairDiffusion, WhatIsNotFiniteIsSaid) {
  Problem problem = makeProblem(500);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  std::vector<float> u = problem.right;
  problem.right[15] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(solve(diffusion, {.mass = {1, 1}, .stiffness = {1, 1}}, problem.right, u), SolverError);
}

}  // namespace
}  // namespace stipple
