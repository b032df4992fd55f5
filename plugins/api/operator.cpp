#include "plugins/api/operator.h"

#include <utility>

namespace stipple {

namespace {

class OneShotRun final : public Run {
 public:
  OneShotRun(PointSet snapshot, Region region, Parameters parameters, OneShotFunction function)
      : snapshot_(std::move(snapshot)),
        region_(std::move(region)),
        parameters_(std::move(parameters)),
        function_(std::move(function)),
        result_{.points = snapshot_} {}

  StepState step(Progress& progress) override {
    Report report;
    result_ =
        function_({.points = snapshot_, .region = region_, .parameters = parameters_}, progress, report);
    report_ = std::move(report);
    return {.finished = true, .fraction = 1};
  }
  void set(const Parameters& parameters) override { parameters_ = parameters; }
  RunResult result() const override { return result_; }
  Report report() const override { return report_; }

 private:
  PointSet snapshot_;
  Region region_;
  Parameters parameters_;
  OneShotFunction function_;
  RunResult result_;
  Report report_;
};

class OneShot final : public Operator {
 public:
  OneShot(OperatorDescription description, OneShotFunction function)
      : description_(std::move(description)), function_(std::move(function)) {}

  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region region, const Parameters& parameters) const override {
    return std::make_unique<OneShotRun>(std::move(snapshot), std::move(region), parameters, function_);
  }

 private:
  OperatorDescription description_;
  OneShotFunction function_;
};

}  // namespace

const char* nameOf(RegionUse use) {
  switch (use) {
    case RegionUse::kNone:
      return "none";
    case RegionUse::kLimits:
      return "limits";
    case RegionUse::kMask:
      return "mask";
  }
  return "";
}

std::unique_ptr<Operator> makeOneShot(OperatorDescription description, OneShotFunction function) {
  return std::make_unique<OneShot>(std::move(description), std::move(function));
}

}  // namespace stipple
