#pragma once

#include <Eigen/Core>
#include <array>
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
  RunResult result() const override;
  Report report() const override;

 private:
  /// A point as it is now.
  struct Row {
    Eigen::Vector3d place, firstPlace;    // exact
    Eigen::Vector3f normal, firstNormal;  // of one sense
    double weight = 1;                    // of its motion; 0: it stays
    double rest = 0;                      // spacing round it at first
    Index source = kAdded;                // row of the snapshot
    bool isRim = false;                   // on the boundary at first
  };
  static constexpr Index kAdded = static_cast<Index>(-1);

  void readWeights();
  void refresh(Progress& progress);
  void beginRows(const FairingSurface& surface, const Progress& progress);
  void resample(const Discretization& d);
  PointSet between(const std::vector<std::array<Index, 2>>& parents) const;
  bool isHeld(const Row& row) const { return row.weight == 0 || (options_.pinBoundary && row.isRim); }
  std::vector<Index> heldSites() const;
  Eigen::MatrixXd findMotion(Progress& progress);
  Eigen::MatrixXd solve(const std::vector<Index>& held, const Progress& progress);
  void keepVolume(Eigen::MatrixXd& motion, const std::vector<Index>& held) const;
  double move(const Eigen::MatrixXd& motion);
  void write();

  PointSet snapshot_, result_;
  Region region_;
  FairingOptions options_;
  std::vector<Row> rows_;  // of result_

  std::unique_ptr<FairingSurface> surface_;
  std::unique_ptr<DiffusionStepper> stepper_;  // null when it has to be made
  double squaredSpacing_ = 0;                  // of the snapshot
  int steps_ = 0, stepsOfSurface_ = 0;
  double time_ = 0;  // length^2
};

}  // namespace stipple
