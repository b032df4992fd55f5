#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/fem/assembly.h"
#include "plugins/fairing/fairing_options.h"

namespace stipple {

/// The surface as it is at one time, made ready for some steps: rows of everything are its sites.
class FairingSurface {
 public:
  FairingSurface(const PointSet& points, const FairingOptions& options, Progress& progress);

  const Discretization& discretization() const { return discretization_; }
  const SparseMatrix& stiffness() const { return stiffness_; }
  /// Mean of the masses, length^2.
  double squaredSpacing() const { return squaredSpacing_; }
  double noise() const { return noise_; }  ///< in mean spacings
  int neighbors() const { return neighbors_; }

 private:
  Discretization discretization_;
  SparseMatrix stiffness_;
  double squaredSpacing_ = 0, noise_ = 0;
  int neighbors_ = 0;
};

/// Neighbors of the classifier for a noise in mean spacings: 60 up to .5, 120 from 1 on.
int classifierNeighbors(double noise);

}  // namespace stipple
