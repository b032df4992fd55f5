#include "core/pde/diffusion.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace stipple {

namespace {

// Rows that are given, or that no path of nonzero entries joins to a given row.
std::vector<Index> findFixedRows(const SparseMatrix& stiffness, std::span<const Index> unknown,
                                 std::vector<Index>& unreached) {
  std::vector<bool> reached(stiffness.rows(), true);
  for (const Index row : unknown) {
    if (row >= stiffness.rows()) {
      throw InvalidInput(
          fmt::format("unknown row {} is not a row of a matrix with {} rows", row, stiffness.rows()));
    }
    reached[row] = false;
  }
  std::vector<Index> fixed;
  for (Index row = 0; row < stiffness.rows(); ++row) {
    if (reached[row]) fixed.push_back(row);
  }
  std::vector<Index> front = fixed;
  while (!front.empty()) {
    const Index row = front.back();
    front.pop_back();
    for (SparseMatrix::InnerIterator entry(stiffness, row); entry; ++entry) {
      if (entry.value() == 0 || reached[entry.col()]) continue;
      reached[entry.col()] = true;
      front.push_back(static_cast<Index>(entry.col()));
    }
  }
  for (Index row = 0; row < stiffness.rows(); ++row) {
    if (!reached[row]) unreached.push_back(row);
  }
  fixed.insert(fixed.end(), unreached.begin(), unreached.end());
  return fixed;
}

}  // namespace

SparseMatrix diffusionMatrix(const SparseMatrix& stiffness, std::span<const double> mass, double timeStep) {
  if (mass.size() != static_cast<std::size_t>(stiffness.rows())) {
    throw InvalidInput(
        fmt::format("{} masses do not fit a matrix with {} rows", mass.size(), stiffness.rows()));
  }
  if (!(timeStep >= 0) || !std::isfinite(timeStep)) {
    throw InvalidInput(fmt::format("the time step is {}, expected a finite number >= 0", timeStep));
  }
  SparseMatrix matrix = timeStep * stiffness;
  for (Index row = 0; row < mass.size(); ++row) {
    if (!(mass[row] > 0)) throw InvalidInput(fmt::format("mass[{}] is {}, expected > 0", row, mass[row]));
    matrix.coeffRef(row, row) += mass[row];
  }
  matrix.makeCompressed();
  return matrix;
}

DiffusionStepper::DiffusionStepper(const SparseMatrix& stiffness, std::span<const double> mass,
                                   const DiffusionOptions& options, const Progress* progress)
    : mass_(Eigen::Map<const Eigen::VectorXd>(mass.data(), mass.size())),
      timeStep_(options.timeStep),
      constraints_(diffusionMatrix(stiffness, mass, options.timeStep), options.held),
      solver_(constraints_.freeMatrix(), options.solver, progress) {}

SolveReport DiffusionStepper::step(Eigen::Ref<Eigen::MatrixXd> u,
                                   const Eigen::Ref<const Eigen::MatrixXd>& source,
                                   const Progress* progress) const {
  Eigen::MatrixXd b = u;
  if (source.size() > 0) b += timeStep_ * source;
  b = mass_.asDiagonal() * b;
  Eigen::MatrixXd next = constraints_.gather(u);
  const SolveReport report = solver_.solve(constraints_.reduce(b, u), next, progress);
  constraints_.scatter(next, u);
  return report;
}

SolveReport DiffusionStepper::step(Eigen::Ref<Eigen::MatrixXd> u, const Progress* progress) const {
  return step(u, Eigen::MatrixXd(), progress);
}

EllipticSolver::EllipticSolver(const SparseMatrix& stiffness, std::span<const Index> unknown,
                               const SolverOptions& options, const Progress* progress)
    : unknown_(unknown.begin(), unknown.end()),
      constraints_(stiffness, findFixedRows(stiffness, unknown_, unreached_)),
      solver_(constraints_.freeMatrix(), options, progress) {}

void EllipticSolver::update(const SparseMatrix& stiffness, const Progress* progress) {
  unreached_.clear();
  constraints_ = DirichletConstraints(stiffness, findFixedRows(stiffness, unknown_, unreached_));
  solver_.update(constraints_.freeMatrix(), progress);
}

SolveReport EllipticSolver::solve(Eigen::Ref<Eigen::MatrixXd> u, const Progress* progress) const {
  Eigen::MatrixXd values = constraints_.gather(u);
  const SolveReport report =
      solver_.solve(constraints_.reduce(Eigen::MatrixXd::Zero(u.rows(), u.cols()), u), values, progress);
  constraints_.scatter(values, u);
  return report;
}

}  // namespace stipple
