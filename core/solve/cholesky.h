#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/fem/assembly.h"
#include "core/progress.h"

namespace stipple {

/// Supernodal factorization A = L L^T of a symmetric positive definite matrix (CHOLMOD, minimum-degree
/// ordering). Immutable after factorize; solve may be called from several threads.
class CholeskyFactor {
 public:
  CholeskyFactor();
  ~CholeskyFactor();
  CholeskyFactor(const CholeskyFactor&) = delete;
  CholeskyFactor& operator=(const CholeskyFactor&) = delete;

  /// Keeps the ordering of the last factorization where `matrix` has the same pattern. Throws SolverError
  /// where the matrix is not positive definite or memory runs out.
  void factorize(const SparseMatrix& matrix);
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The same factorization, abandoned (it ends by itself in the background) when `progress` says to stop.
void factorizeInterruptibly(std::shared_ptr<CholeskyFactor>& factor, const SparseMatrix& matrix,
                            const Progress* progress);

}  // namespace stipple
