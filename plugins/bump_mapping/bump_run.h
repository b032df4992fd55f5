#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "plugins/api/operator.h"

namespace stipple {

enum class GradientMethod { kFan, kRadial };

/// The only step computes gradients, where it has none yet, and tilts the normals: another strength costs
/// next to nothing.
class BumpRun final : public Run {
 public:
  /// Throws InvalidInput where there is no such attribute, or it is no number.
  BumpRun(PointSet snapshot, const Parameters& parameters);

  StepState step(Progress& progress) override;
  void set(const Parameters& parameters) override;
  RunResult result() const override { return {.points = result_}; }
  Report report() const override { return report_; }

 private:
  /// Of the points.
  struct Relief {
    std::vector<Eigen::Vector3f> normals;    ///< unit, of one sense
    std::vector<Eigen::Vector3d> gradients;  ///< tangential, finite
    double steep = 0;                        ///< the 95 % quantile of their lengths
  };
  Relief measure(Progress& progress) const;

  PointSet snapshot_, result_;
  Parameters parameters_;
  std::unique_ptr<const Relief> relief_;
  Report report_;
};

}  // namespace stipple
