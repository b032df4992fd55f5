#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/fem/constraints.h"
#include "core/solve/linear_solver.h"

namespace stipple {

/// M + tau L: `mass` in length^2, > 0; tau >= 0 in length^2. Throws InvalidInput otherwise.
SparseMatrix diffusionMatrix(const SparseMatrix& stiffness, std::span<const double> mass, double timeStep);

struct DiffusionOptions {
  double timeStep = 0;      ///< tau, length^2
  std::vector<Index> held;  ///< rows that keep their values (Dirichlet)
  SolverOptions solver;
};

/// Implicit diffusion with a source: (M + tau L) u' = M (u + tau f), Section 4 of the paper. One preparation,
/// many steps, any number of fields (n x c) at once.
class DiffusionStepper {
 public:
  DiffusionStepper(const SparseMatrix& stiffness, std::span<const double> mass,
                   const DiffusionOptions& options, const Progress* progress = nullptr);

  /// Advances `u` by one step; `u` is also the initial guess. `source` is f, n x c, or empty for none.
  SolveReport step(Eigen::Ref<Eigen::MatrixXd> u, const Eigen::Ref<const Eigen::MatrixXd>& source,
                   const Progress* progress = nullptr) const;
  SolveReport step(Eigen::Ref<Eigen::MatrixXd> u, const Progress* progress = nullptr) const;

  const LinearSolver& solver() const { return solver_; }

 private:
  Eigen::VectorXd mass_;
  double timeStep_;
  DirichletConstraints constraints_;
  LinearSolver solver_;
};

/// Continues values from known rows B into the unknown rows D so that div(A grad u) = 0: L_DD u_D = -L_DB
/// u_B.
class EllipticSolver {
 public:
  /// `unknown`: the rows D, in any order.
  EllipticSolver(const SparseMatrix& stiffness, std::span<const Index> unknown, const SolverOptions& options,
                 const Progress* progress = nullptr);

  /// Fills the unknown rows of n x c columns; what they held is the initial guess.
  SolveReport solve(Eigen::Ref<Eigen::MatrixXd> u, const Progress* progress = nullptr) const;
  /// Takes another stiffness for the same unknown rows; with the same pattern the ordering is kept.
  void update(const SparseMatrix& stiffness, const Progress* progress = nullptr);
  /// Unknown rows that no path of nonzero couplings joins to a known row: solve leaves them as they are.
  const std::vector<Index>& unreached() const { return unreached_; }

 private:
  std::vector<Index> unknown_, unreached_;
  DirichletConstraints constraints_;
  LinearSolver solver_;
};

}  // namespace stipple
