#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/fem/laplacian_builder.h"
#include "core/geometry/sites.h"

namespace stipple {

/// Rows of W^T L W in the order of the file (n x n), W averaging the copies of a place; made one at a time,
/// since the copies of one place make a dense block. Refers to both arguments.
class PointRows {
 public:
  using Entry = std::pair<Index, double>;  // column, value

  PointRows(const Sites& sites, const SparseMatrix& stiffness);
  Index size() const { return static_cast<Index>(sites_.siteOfPoint.size()); }
  /// Entries of the row up to the diagonal, columns ascending; zeros only on the diagonal.
  void lowerRow(Index point, std::vector<Entry>& entries) const;
  /// Entries of all lower rows. Throws InvalidInput beyond 2^31, which no reader of sparse matrices takes.
  std::size_t countLower() const;

 private:
  std::span<const Index> copiesOf(Index site) const {
    return {copies_.data() + begins_[site], begins_[site + 1] - begins_[site]};
  }

  const Sites& sites_;
  const SparseMatrix& stiffness_;
  std::vector<Index> begins_, copies_;  // file rows at each site, ascending
};

/// Masses of the file rows: the copies of a place share its mass.
std::vector<double> expandMassToPoints(const Sites& sites, std::span<const double> mass);

}  // namespace stipple
