#pragma once

#include <memory>
#include <optional>

#include "core/pde/diffusion.h"
#include "plugins/api/operator.h"
#include "plugins/attribute_smoothing/smoothing_surface.h"

namespace stipple {

enum class SmoothingMethod { kHeat, kEdgePreserving };

/// One step is one implicit step of diffusion; the first also prepares the surface. Parameters act at the
/// next step; another attribute or discretization starts anew.
class SmoothingRun final : public Run {
 public:
  /// Throws InvalidInput where there is no such attribute.
  SmoothingRun(PointSet snapshot, Region region, const Parameters& parameters);

  StepState step(Progress& progress) override;
  void set(const Parameters& parameters) override;
  RunResult result() const override { return {.points = result_}; }
  Report report() const override;

 private:
  const Attribute& attribute() const;
  std::unique_ptr<DiffusionStepper> makeStepper(const Progress& progress);
  void write();

  PointSet snapshot_, result_;
  Region region_;
  Parameters parameters_;
  std::unique_ptr<SmoothingSurface> surface_;
  std::unique_ptr<DiffusionStepper> stepper_;  // of the heat equation; null when it has to be made
  Eigen::MatrixXd values_;                     // of the sites
  int steps_ = 0;
};

}  // namespace stipple
