#include "core/solve/linear_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/solve/cholesky.h"
#include "core/solve/conjugate_gradient.h"

namespace stipple {

namespace {

void requireUsable(const SparseMatrix& matrix) {
  if (matrix.rows() != matrix.cols()) {
    throw InvalidInput(fmt::format("the matrix has {} rows and {} columns, expected a square one",
                                   matrix.rows(), matrix.cols()));
  }
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
      if (!std::isfinite(entry.value())) {
        throw SolverError(fmt::format("matrix entry ({}, {}) is {}", row, entry.col(), entry.value()));
      }
    }
  }
}

void requireFinite(const Eigen::Ref<const Eigen::MatrixXd>& values, const char* name) {
  if (values.allFinite()) return;
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (!std::isfinite(values(i, c))) throw SolverError(fmt::format("{}[{}] is {}", name, i, values(i, c)));
    }
  }
}

// Worst |b - A x| / |b| of the columns.
double relativeResidual(const SparseMatrix& a, const Eigen::Ref<const Eigen::MatrixXd>& b,
                        const Eigen::Ref<const Eigen::MatrixXd>& x) {
  constexpr std::size_t kGrain = 4096;
  double worst = 0;
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    const double squared = parallelSum(a.rows(), kGrain, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t row = begin; row < end; ++row) {
        double r = b(row, c);
        for (SparseMatrix::InnerIterator entry(a, row); entry; ++entry)
          r -= entry.value() * x(entry.col(), c);
        sum += r * r;
      }
      return sum;
    });
    if (const double norm = b.col(c).norm(); norm > 0) worst = std::max(worst, std::sqrt(squared) / norm);
  }
  return worst;
}

// Eigenvalues of the matrix scaled by its diagonal reach up to 2; the smallest is about the ratio of row sum
// to diagonal. From above by the size: the front of an iteration crosses the surface in some sqrt(n) steps.
double expectedIterations(const SparseMatrix& matrix, double tolerance) {
  const Eigen::VectorXd rowSums = matrix * Eigen::VectorXd::Ones(matrix.cols());
  const double ratio = 2 * matrix.diagonal().sum() / std::max(rowSums.cwiseMax(0).sum(), 1e-300);
  const double digits = 0.5 * std::log(2 / std::max(tolerance, 1e-15));
  return digits * std::sqrt(std::min(ratio, static_cast<double>(matrix.rows())));
}

}  // namespace

SolverMethod chooseMethod(const SparseMatrix& matrix, const SolverOptions& options) {
  if (options.method != SolverMethod::kAuto) return options.method;
  // Nanoseconds a row, measured on two cores at 36 k to 1 M rows of 7 entries. The factor has about n log n
  // entries.
  const double n = std::max<double>(matrix.rows(), 2);
  const double iterating = 11 * n * expectedIterations(matrix, options.tolerance) * options.expectedSolves;
  const double factoring = n * (280 * std::log2(n) + 12 * std::log2(n) * options.expectedSolves);
  // The factor of a few million rows no longer fits the memory of a laptop (about 0.8 GB a million).
  constexpr double kMostRows = 4e6;
  return n <= kMostRows && factoring < iterating ? SolverMethod::kCholesky : SolverMethod::kConjugateGradient;
}

LinearSolver::LinearSolver(SparseMatrix matrix, const SolverOptions& options, const Progress* progress)
    : matrix_(std::move(matrix)), options_(options), method_(options.method) {
  prepare(progress);
}

LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::update(SparseMatrix matrix, const Progress* progress) {
  matrix_ = std::move(matrix);
  prepare(progress);
}

void LinearSolver::prepare(const Progress* progress) {
  requireUsable(matrix_);
  matrix_.makeCompressed();
  method_ = chooseMethod(matrix_, options_);
  if (method_ != SolverMethod::kCholesky || matrix_.rows() == 0) return;
  if (!factor_) factor_ = std::make_shared<CholeskyFactor>();
  factorizeInterruptibly(factor_, matrix_, progress);
}

SolveReport LinearSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x,
                                const Progress* progress) const {
  if (b.rows() != matrix_.rows() || x.rows() != b.rows() || x.cols() != b.cols()) {
    throw InvalidInput(
        fmt::format("right-hand side of {} x {} and solution of {} x {} do not fit a matrix with {} rows",
                    b.rows(), b.cols(), x.rows(), x.cols(), matrix_.rows()));
  }
  requireFinite(b, "right-hand side");
  if (progress) progress->throwIfCancelled();
  if (b.size() == 0) return {};
  if (method_ == SolverMethod::kConjugateGradient) {
    requireFinite(x, "initial guess");
    return solveByConjugateGradient(matrix_, b, x, options_, progress);
  }
  factor_->solve(b, x);
  return {0, relativeResidual(matrix_, b, x)};
}

}  // namespace stipple
