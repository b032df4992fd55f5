#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/fem/assembly.h"
#include "core/geometry/creases.h"
#include "core/points/region.h"

namespace stipple {

/// The surface that an attribute flows on. Rows of everything are the sites of the discretization.
class SmoothingSurface {
 public:
  SmoothingSurface(const PointSet& points, const Attribute& attribute, const Region& region,
                   const DiscretizationOptions& options, Progress& progress);

  const Discretization& discretization() const { return discretization_; }
  double squaredSpacing() const { return squaredSpacing_; }
  const Eigen::MatrixXd& givenValues() const { return givenValues_; }     ///< 0 where not finite
  const std::vector<Index>& heldSites() const { return heldSites_; }      ///< with a point outside the region
  const std::vector<Index>& writtenRows() const { return writtenRows_; }  ///< in the region, of finite values

  /// L, between creases where asked for. What has no finite value takes no part.
  SparseMatrix stiffness(bool blocksCreases, const Progress& progress);
  /// L with A = exp(-|grad u|^2 / s^2), s the gradient that an eighth of the sites exceed in `values`.
  SparseMatrix edgePreservingStiffness(const Eigen::MatrixXd& values, bool blocksCreases,
                                       const Progress& progress);

 private:
  SparseMatrix stiffnessTimes(const std::vector<double>& diffusivity, bool blocksCreases,
                              const Progress& progress);

  Discretization discretization_;
  double squaredSpacing_ = 0;
  Eigen::MatrixXd givenValues_;
  std::vector<std::uint8_t> isFinite_;
  bool allFinite_ = true;
  std::vector<Index> heldSites_, writtenRows_;
  std::vector<OneSidedPlane> planes_;  // of the sites; empty until creases are asked for
};

}  // namespace stipple
