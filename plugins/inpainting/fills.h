#pragma once

#include <optional>

#include "core/pde/diffusion.h"
#include "plugins/inpainting/shading.h"

namespace stipple {

struct FillStep {
  double change = 0;    ///< root mean square change of the unknown values, in units of the known range
  double fraction = 0;  ///< 1: finished
};

/// div(C grad u) = 0 inside, u given at the rim (Section 8.4). Shown as it spreads: each step diffuses what
/// is left of the error, the last one leaves none.
class HarmonicFill {
 public:
  HarmonicFill(Hole& hole, const Progress& progress);
  FillStep step(Hole& hole, const Progress& progress);
  const std::vector<Index>& unreached() const { return unreached_; }

 private:
  std::vector<Index> unreached_;
  Eigen::MatrixXd solution_;
  std::optional<DiffusionStepper> stepper_;
  int steps_ = 0;
};

/// div(C A(u) grad u) = 0 with A = 1 along edges of u and small across them, where edges are found in what
/// the step before has. The first step is the harmonic fill. Of colors, what the relief does to their light
/// is taken off before and put on after.
class TensorFill {
 public:
  TensorFill(Hole& hole, const Progress& progress);
  FillStep step(Hole& hole, const Progress& progress);
  const std::vector<Index>& unreached() const { return unreached_; }

 private:
  std::vector<Index> unreached_;
  Shading shading_;
  EllipticSolver solver_;  // of the harmonic fill at first
  int steps_ = 0;
};

/// lap(lap u) = 0 inside, u given at the rim and outside: L M^-1 L u = 0. Smooth, may overshoot.
class BiharmonicFill {
 public:
  BiharmonicFill(Hole& hole, const Progress& progress);
  FillStep step(Hole& hole, const Progress& progress);
  const std::vector<Index>& unreached() const { return solver_->unreached(); }

 private:
  std::optional<EllipticSolver> solver_;
};

/// Root mean square over the unknown sites and channels, in units of the known range of each channel.
double changeOf(const Hole& hole, const Eigen::MatrixXd& before);

}  // namespace stipple
