#include "core/fem/constraints.h"

#include <fmt/format.h>

#include "core/error.h"

namespace stipple {

namespace {

// Rows `rows` and columns `columns` of a matrix; both ascending.
SparseMatrix extract(const SparseMatrix& matrix, std::span<const Index> rows,
                     std::span<const Index> columns) {
  std::vector<int> newColumn(matrix.cols(), -1);
  for (std::size_t c = 0; c < columns.size(); ++c) newColumn[columns[c]] = static_cast<int>(c);
  SparseMatrix part(rows.size(), columns.size());
  Eigen::Index entries = 0;
  for (const Index row : rows) entries += matrix.outerIndexPtr()[row + 1] - matrix.outerIndexPtr()[row];
  part.reserve(entries);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    part.startVec(r);
    for (SparseMatrix::InnerIterator entry(matrix, rows[r]); entry; ++entry) {
      const int column = newColumn[entry.col()];
      if (column >= 0) part.insertBack(r, column) = entry.value();
    }
  }
  part.finalize();
  return part;
}

}  // namespace

DirichletConstraints::DirichletConstraints(const SparseMatrix& matrix, std::span<const Index> held) {
  std::vector<bool> isHeld(matrix.rows(), false);
  for (const Index row : held) {
    if (row >= matrix.rows()) {
      throw InvalidInput(
          fmt::format("held row {} is not a row of a matrix with {} rows", row, matrix.rows()));
    }
    isHeld[row] = true;
  }
  for (Index row = 0; row < matrix.rows(); ++row) (isHeld[row] ? heldRows_ : freeRows_).push_back(row);
  freeMatrix_ = extract(matrix, freeRows_, freeRows_);
  coupling_ = extract(matrix, freeRows_, heldRows_);
}

Eigen::MatrixXd DirichletConstraints::reduce(const Eigen::Ref<const Eigen::MatrixXd>& b,
                                             const Eigen::Ref<const Eigen::MatrixXd>& u) const {
  if (heldRows_.empty()) return b;
  Eigen::MatrixXd boundary(heldRows_.size(), u.cols());
  for (std::size_t h = 0; h < heldRows_.size(); ++h) boundary.row(h) = u.row(heldRows_[h]);
  return gather(b) - coupling_ * boundary;
}

Eigen::MatrixXd DirichletConstraints::gather(const Eigen::Ref<const Eigen::MatrixXd>& u) const {
  Eigen::MatrixXd values(freeRows_.size(), u.cols());
  for (Eigen::Index c = 0; c < u.cols(); ++c) {
    for (std::size_t f = 0; f < freeRows_.size(); ++f) values(f, c) = u(freeRows_[f], c);
  }
  return values;
}

void DirichletConstraints::scatter(const Eigen::Ref<const Eigen::MatrixXd>& freeValues,
                                   Eigen::Ref<Eigen::MatrixXd> u) const {
  for (Eigen::Index c = 0; c < u.cols(); ++c) {
    for (std::size_t f = 0; f < freeRows_.size(); ++f) u(freeRows_[f], c) = freeValues(f, c);
  }
}

}  // namespace stipple
