#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "core/fem/assembly.h"
#include "core/progress.h"

namespace stipple {

enum class SolverMethod { kAuto, kConjugateGradient, kCholesky };

struct SolverOptions {
  SolverMethod method = SolverMethod::kAuto;
  double tolerance = 1e-8;  ///< of conjugate gradients: |b - A x| <= tolerance |b|, for each column
  int maxIterations = 20000;
  int expectedSolves = 1;  ///< columns that will be solved with one matrix: what the choice of kAuto weighs
};

/// What the last solve took: iterations of the slowest column (0 for Cholesky), worst |b - A x| / |b|.
struct SolveReport {
  int iterations = 0;
  double residual = 0;
};

/// The method that kAuto stands for: the cheaper one by size, expected solves and the iterations that the
/// matrix will need (from the ratio of its diagonal to its row sums, which for M + tau L is that of tau to
/// h^2).
SolverMethod chooseMethod(const SparseMatrix& matrix, const SolverOptions& options);

/// Solves A x = b for one symmetric positive definite A (both triangles stored) and many b. Throws
/// SolverError where A is not positive definite, b is not finite, or the iteration does not converge;
/// Cancelled when asked to stop.
class LinearSolver {
 public:
  /// Prepares the matrix: a factorization where the method is Cholesky.
  LinearSolver(SparseMatrix matrix, const SolverOptions& options, const Progress* progress = nullptr);
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// n x c columns; `x` holds the initial guess (ignored by Cholesky) and receives the solution.
  SolveReport solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x,
                    const Progress* progress = nullptr) const;
  /// Takes new values; with the same pattern the ordering of a factorization is kept.
  void update(SparseMatrix matrix, const Progress* progress = nullptr);

  SolverMethod method() const { return method_; }
  Index size() const { return static_cast<Index>(matrix_.rows()); }

 private:
  void prepare(const Progress* progress);

  SparseMatrix matrix_;
  SolverOptions options_;
  SolverMethod method_;
  std::shared_ptr<class CholeskyFactor> factor_;
};

}  // namespace stipple
