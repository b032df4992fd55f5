#include "plugins/texture_synthesis/pair_diffusion.h"

#include <gtest/gtest.h>

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
  std::vector<Pair> right;
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
    const float a = uniform(random), b = uniform(random);
    problem.right.push_back(Pair{a, b});
  }
  return problem;
}

Eigen::VectorXd solveExactly(const Problem& problem, const PairTerms& terms, int lane) {
  const auto which = static_cast<std::size_t>(lane);
  const auto size = static_cast<Eigen::Index>(problem.right.size());
  Eigen::VectorXd b(size);
  SparseMatrix matrix = terms.stiffness[which] * problem.stiffness;
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const double mass = problem.discretization.mass[row];
    matrix.coeffRef(i, i) += terms.mass[which] * mass;
    b[i] = mass * static_cast<double>(problem.right[row][lane]);
  }
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(b);
}

// L2 distance to the exact solution, relative to that of the right-hand side: to the change of a step.
double relativeError(const Problem& problem, const Eigen::VectorXd& exact, std::span<const Pair> u,
                     int lane) {
  double error = 0, change = 0;
  for (std::size_t row = 0; row < u.size(); ++row) {
    const double mass = problem.discretization.mass[row], value = exact[static_cast<Eigen::Index>(row)];
    error += mass * std::pow(static_cast<double>(u[row][lane]) - value, 2);
    change += mass * std::pow(static_cast<double>(problem.right[row][lane]) - value, 2);
  }
  return std::sqrt(error / change);
}

TEST(PairDiffusion, ApproachesTheExactSolutionOfBothSpecies) {
  const Problem problem = makeProblem(3000);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  const double h2 = problem.spacing * problem.spacing;
  const PairTerms terms = {.mass = {1, 1.2}, .stiffness = {0.5 * h2, 2 * h2}};
  const Eigen::VectorXd exact[] = {solveExactly(problem, terms, 0), solveExactly(problem, terms, 1)};
  std::vector<Pair> u = problem.right;
  EXPECT_GT(diffusion.solve(terms, problem.right, u), 0);
  for (int lane = 0; lane < 2; ++lane) EXPECT_LT(relativeError(problem, exact[lane], u, lane), 0.2) << lane;
  // What is left of the residual is worked off by later calls.
  for (int call = 0; call < 6; ++call) diffusion.solve(terms, problem.right, u);
  for (int lane = 0; lane < 2; ++lane) EXPECT_LT(relativeError(problem, exact[lane], u, lane), 1e-5) << lane;
}

TEST(PairDiffusion, ConstantsStayAsTheyAre) {
  const Problem problem = makeProblem(500);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  const std::vector<Pair> constant(500, Pair{4, 0.3f});
  std::vector<Pair> u = constant;
  EXPECT_EQ(diffusion.solve({.mass = {1, 1}, .stiffness = {1, 1}}, constant, u), 0);
  for (const Pair& value : u) {
    EXPECT_EQ(value[0], 4);
    EXPECT_EQ(value[1], 0.3f);
  }
}

TEST(PairDiffusion, AnIndefiniteMatrixIsRefused) {
  const Problem problem = makeProblem(500);
  const SparseMatrix negative = -problem.stiffness;
  PairDiffusion diffusion(negative, problem.discretization.mass, problem.spacing);
  std::vector<Pair> u = problem.right;
  const double tau = 10 * problem.spacing * problem.spacing;
  EXPECT_THROW(diffusion.solve({.mass = {1, 1}, .stiffness = {tau, tau}}, problem.right, u), SolverError);
}

TEST(PairDiffusion, WhatIsNotFiniteIsSaid) {
  Problem problem = makeProblem(500);
  PairDiffusion diffusion(problem.stiffness, problem.discretization.mass, problem.spacing);
  std::vector<Pair> u = problem.right;
  problem.right[7][1] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(diffusion.solve({.mass = {1, 1}, .stiffness = {1, 1}}, problem.right, u), SolverError);
}

}  // namespace
}  // namespace stipple
