#include "core/solve/conjugate_gradient.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stipple {

namespace {

// Rows of one block of a parallel loop: long enough to hide the cost of handing it out, short enough for the
// cache.
constexpr Eigen::Index kGrain = 4096;

// One number for each of the C columns that are iterated together.
template <int C>
using Columns = Eigen::Array<double, 1, C>;

// A row of C values lies together, so that one pass over the matrix serves all columns.
template <int C>
using Field = Eigen::Array<double, Eigen::Dynamic, C, C == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

template <int C>
class Iteration {
 public:
  Iteration(const SparseMatrix& matrix, const Eigen::ArrayXd& inverseDiagonal)
      : a_(matrix), inverseDiagonal_(inverseDiagonal), partials_((matrix.rows() + kGrain - 1) / kGrain) {}

  SolveReport run(const Field<C>& b, Field<C>& x, const SolverOptions& options, const Progress* progress) {
    start(b, x);
    const Columns<C> target = (options.tolerance * bNorm_.sqrt()).square();
    int iteration = 0;
    while ((rr_ > target).any()) {
      if (iteration == options.maxIterations) {
        throw SolverError(fmt::format(
            "conjugate gradients did not converge: {} iterations left a relative residual of {:.3g}, "
            "expected {:.3g}",
            iteration, relativeResidual(), options.tolerance));
      }
      if (progress && iteration % 8 == 0) progress->throwIfCancelled();
      // Columns that have converged rest, so that a column's result does not depend on its companions.
      step(x, (rr_ > target).template cast<double>());
      ++iteration;
    }
    return {iteration, trueResidual(b, x)};
  }

 private:
  using Sums = std::array<Columns<C>, 2>;

  // body(row, sums) over all rows; the sums of the blocks are added in their order.
  template <class Body>
  Sums forRows(const Body& body) {
    parallelFor(a_.rows(), kGrain, [&](std::size_t begin, std::size_t end) {
      Sums sums{Columns<C>::Zero(), Columns<C>::Zero()};
      for (auto row = static_cast<Eigen::Index>(begin); row < static_cast<Eigen::Index>(end); ++row)
        body(row, sums);
      partials_[begin / kGrain] = sums;
    });
    Sums total{Columns<C>::Zero(), Columns<C>::Zero()};
    for (const Sums& part : partials_) {
      total[0] += part[0];
      total[1] += part[1];
    }
    return total;
  }

  Columns<C> rowTimes(Eigen::Index row, const Field<C>& v) const {
    const int* column = a_.innerIndexPtr();
    const double* value = a_.valuePtr();
    Columns<C> sum = Columns<C>::Zero();
    for (int k = a_.outerIndexPtr()[row]; k < a_.outerIndexPtr()[row + 1]; ++k)
      sum += value[k] * v.row(column[k]);
    return sum;
  }

  void start(const Field<C>& b, Field<C>& x) {
    r_.resize(b.rows(), C);
    p_.resize(b.rows(), C);
    q_.resize(b.rows(), C);
    bNorm_ = forRows([&](Eigen::Index i, Sums& sums) { sums[0] += b.row(i).square(); })[0];
    for (int c = 0; c < C; ++c) {
      if (bNorm_[c] == 0) x.col(c).setZero();
    }
    const Sums sums = forRows([&](Eigen::Index i, Sums& s) {
      const Columns<C> r = b.row(i) - rowTimes(i, x);
      r_.row(i) = r;
      p_.row(i) = inverseDiagonal_[i] * r;
      s[0] += r.square();
      s[1] += inverseDiagonal_[i] * r.square();
    });
    rr_ = sums[0];
    rz_ = sums[1];
  }

  void step(Field<C>& x, const Columns<C>& active) {
    const Columns<C> curvature = forRows([&](Eigen::Index i, Sums& s) {
      const Columns<C> q = rowTimes(i, p_);
      q_.row(i) = q;
      s[0] += q * p_.row(i);
    })[0];
    if (!(curvature > 0 || active == 0).all()) {
      throw SolverError(
          "the matrix is not positive definite: conjugate gradients met a direction of negative curvature");
    }
    const Columns<C> alpha = (active > 0).select(rz_ / curvature, 0.0);
    const Sums sums = forRows([&](Eigen::Index i, Sums& s) {
      x.row(i) += alpha * p_.row(i);
      const Columns<C> r = r_.row(i) - alpha * q_.row(i);
      r_.row(i) = r;
      s[0] += r.square();
      s[1] += inverseDiagonal_[i] * r.square();
    });
    const Columns<C> beta = (active > 0).select(sums[1] / rz_, 0.0);
    forRows([&](Eigen::Index i, Sums&) { p_.row(i) = inverseDiagonal_[i] * r_.row(i) + beta * p_.row(i); });
    rr_ = sums[0];
    rz_ = sums[1];
  }

  double relativeResidual() const { return (bNorm_ > 0).select(rr_ / bNorm_, 0.0).sqrt().maxCoeff(); }

  double trueResidual(const Field<C>& b, const Field<C>& x) {
    rr_ = forRows([&](Eigen::Index i, Sums& s) { s[0] += (b.row(i) - rowTimes(i, x)).square(); })[0];
    return relativeResidual();
  }

  const SparseMatrix& a_;
  const Eigen::ArrayXd& inverseDiagonal_;
  std::vector<Sums> partials_;
  Field<C> r_, p_, q_;
  Columns<C> bNorm_, rr_, rz_;
};

template <int C>
SolveReport solveColumns(const SparseMatrix& matrix, const Eigen::ArrayXd& inverseDiagonal,
                         const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x,
                         Eigen::Index first, const SolverOptions& options, const Progress* progress) {
  const Field<C> rhs = b.middleCols(first, C).array();
  Field<C> solution = x.middleCols(first, C).array();
  const SolveReport report = Iteration<C>(matrix, inverseDiagonal).run(rhs, solution, options, progress);
  x.middleCols(first, C) = solution.matrix();
  return report;
}

Eigen::ArrayXd invertDiagonal(const SparseMatrix& matrix) {
  const Eigen::ArrayXd diagonal = matrix.diagonal().array();
  for (Eigen::Index i = 0; i < diagonal.size(); ++i) {
    if (!(diagonal[i] > 0)) {
      throw SolverError(
          fmt::format("the matrix is not positive definite: entry ({0}, {0}) is {1}", i, diagonal[i]));
    }
  }
  return diagonal.inverse();
}

}  // namespace

SolveReport solveByConjugateGradient(const SparseMatrix& matrix, const Eigen::Ref<const Eigen::MatrixXd>& b,
                                     Eigen::Ref<Eigen::MatrixXd> x, const SolverOptions& options,
                                     const Progress* progress) {
  const Eigen::ArrayXd inverseDiagonal = invertDiagonal(matrix);
  SolveReport worst;
  for (Eigen::Index first = 0; first < b.cols();) {
    const Eigen::Index count = std::min<Eigen::Index>(b.cols() - first, 4);
    constexpr std::array kSolve = {&solveColumns<1>, &solveColumns<2>, &solveColumns<3>, &solveColumns<4>};
    const SolveReport report = kSolve[count - 1](matrix, inverseDiagonal, b, x, first, options, progress);
    worst.iterations = std::max(worst.iterations, report.iterations);
    worst.residual = std::max(worst.residual, report.residual);
    first += count;
  }
  return worst;
}

}  // namespace stipple
