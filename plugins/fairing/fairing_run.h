#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/pde/diffusion.h"
#include "plugins/api/operator.h"
#include "plugins/fairing/fairing_surface.h"

namespace stipple {

/// One step is one implicit step of the positions; every few of them the surface is made ready anew.
/// Parameters act at the next step.
class FairingRun final : public Run {
 public:
  /// Throws InvalidInput where the weight is no number.
  FairingRun(PointSet snapshot, Region region, const Parameters& parameters);

  StepState step(Progress& progress) override;
  void set(const Parameters& parameters) override;
  RunResult result() const override { return {.points = result_}; }
  Report report() const override;

 private:
  void refresh(Progress& progress);
  std::vector<Index> heldSites() const;
  void keepVolume(Eigen::MatrixXd& motion, const std::vector<Index>& held) const;
  double move(const Eigen::MatrixXd& motion);
  void write(const Eigen::MatrixXd& places);

  PointSet snapshot_, result_;
  Region region_;
  FairingOptions options_;
  std::vector<double> weights_;                          // of the rows; empty: 1
  std::vector<Eigen::Vector3d> rows_;                    // where the points are now, exact
  std::vector<std::uint8_t> isRim_;                      // of the rows: on the boundary of the snapshot
  std::vector<Eigen::Vector3f> normals_, firstNormals_;  // of the rows, of one sense

  std::unique_ptr<FairingSurface> surface_;
  std::unique_ptr<DiffusionStepper> stepper_;  // null when it has to be made
  double squaredSpacing_ = 0;                  // of the snapshot
  int steps_ = 0, stepsOfSurface_ = 0;
  double time_ = 0;  // length^2
};

}  // namespace stipple
