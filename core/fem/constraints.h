#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/fem/assembly.h"

namespace stipple {

/// Dirichlet conditions by elimination: of A u = b with u given at the held rows D there remains
/// A_FF u_F = b_F - A_FD u_D, symmetric as A is. The matrix depends on which rows are held only, so that one
/// factorization serves all boundary values.
class DirichletConstraints {
 public:
  /// `held`: rows in any order, repeats allowed. Throws InvalidInput where one is not a row.
  DirichletConstraints(const SparseMatrix& matrix, std::span<const Index> held);

  const SparseMatrix& freeMatrix() const { return freeMatrix_; }    ///< A_FF
  const std::vector<Index>& freeRows() const { return freeRows_; }  ///< ascending
  const std::vector<Index>& heldRows() const { return heldRows_; }  ///< ascending

  /// b_F - A_FD u_D for n x c columns; of `u` the held rows are read.
  Eigen::MatrixXd reduce(const Eigen::Ref<const Eigen::MatrixXd>& b,
                         const Eigen::Ref<const Eigen::MatrixXd>& u) const;
  /// The free rows of n x c columns, and back.
  Eigen::MatrixXd gather(const Eigen::Ref<const Eigen::MatrixXd>& u) const;
  void scatter(const Eigen::Ref<const Eigen::MatrixXd>& freeValues, Eigen::Ref<Eigen::MatrixXd> u) const;

 private:
  SparseMatrix freeMatrix_, coupling_;  // A_FF, A_FD
  std::vector<Index> freeRows_, heldRows_;
};

}  // namespace stipple
