#pragma once

#include <Eigen/Core>

#include "core/solve/linear_solver.h"

namespace stipple {

/// Conjugate gradients preconditioned by the diagonal, for all columns of b at once (n x c, up to four share
/// a pass over the matrix). `x` holds the initial guess and receives the solution. Sums run in fixed blocks:
/// same bits for any number of threads. Throws SolverError on a direction of negative curvature and when
/// maxIterations are spent.
SolveReport solveByConjugateGradient(const SparseMatrix& matrix, const Eigen::Ref<const Eigen::MatrixXd>& b,
                                     Eigen::Ref<Eigen::MatrixXd> x, const SolverOptions& options,
                                     const Progress* progress = nullptr);

}  // namespace stipple
