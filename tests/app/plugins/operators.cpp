// Operators for tests: one that steps and obeys, one for each way to misbehave.

#include <chrono>
#include <stdexcept>
#include <thread>

#include "plugins/api/plugin.h"

namespace stipple {
namespace {

// Adds `amount` to `height` in each of `steps` steps, taking `milliseconds` for each.
class StepperRun final : public Run {
 public:
  StepperRun(PointSet snapshot, const Parameters& parameters)
      : points_(std::move(snapshot)), parameters_(parameters) {
    if (!points_.has("height")) points_.set("height", std::vector<float>(points_.size(), 0.0f));
  }

  StepState step(Progress& progress) override {
    const auto amount = static_cast<float>(parameters_.number("amount"));
    for (std::int64_t waited = 0; waited < parameters_.integer("milliseconds"); ++waited) {
      progress.throwIfCancelled();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    for (float& height : points_.edit<float>("height")) height += amount;
    progress.publish(points_);
    ++done_;
    const auto steps = parameters_.integer("steps");
    return {.finished = done_ >= steps,
            .fraction = static_cast<double>(done_) / static_cast<double>(steps),
            .curve = amount};
  }
  void set(const Parameters& parameters) override { parameters_ = parameters; }
  RunResult result() const override { return {.points = points_}; }
  Report report() const override {
    Report report;
    report.values.emplace_back("done", done_);
    report.values.emplace_back("not_a_number", std::numeric_limits<double>::quiet_NaN());
    if (parameters_.number("amount") == 0) report.warnings.emplace_back("nothing was added");
    return report;
  }

 private:
  PointSet points_;
  Parameters parameters_;
  std::int64_t done_ = 0;
};

class Stepper final : public Operator {
 public:
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region, const Parameters& parameters) const override {
    return std::make_unique<StepperRun>(std::move(snapshot), parameters);
  }

 private:
  OperatorDescription description_{
      .id = "stepper",
      .title = "Stepper",
      .help = "Adds an amount to height, step by step.",
      .parameters = {{.id = "steps", .type = ParameterType::kInt, .defaultValue = 4, .min = 1, .max = 100000},
                     {.id = "amount", .unit = Unit::kLength, .defaultValue = 1.0},
                     {.id = "milliseconds", .type = ParameterType::kInt, .defaultValue = 0, .min = 0},
                     {.id = "tilt", .unit = Unit::kAngle, .defaultValue = 30.0, .min = 0, .max = 90},
                     {.id = "like", .type = ParameterType::kAttribute, .defaultValue = ""}},
      .writes = {"height"}};
};

// Writes 1 into `inside` within the region, 0 elsewhere.
RunResult markInside(const OneShotInput& input, Progress&, Report&) {
  RunResult result{.points = input.points};
  std::vector<std::int32_t> inside(input.points.size(), 0);
  for (const Index row : input.region.rows(input.points.size())) inside[row] = 1;
  result.points.set("inside", std::move(inside));
  return result;
}

RunResult removeOddRows(const OneShotInput& input, Progress&, Report&) {
  RunResult result{.points = input.points};
  for (Index row = 1; row < input.points.size(); row += 2) result.removedRows.push_back(row);
  result.points.removeRows(result.removedRows);
  return result;
}

RunResult misbehave(const OneShotInput& input, Progress&, Report&) {
  const std::string& how = input.parameters.text("how");
  if (how == "invalid_input") throw InvalidInput("the points are too blue");
  if (how == "standard") throw std::runtime_error("first line\nsecond line");
  if (how == "number") throw 42;
  if (how == "memory") throw std::bad_alloc();
  PointSet fewer = input.points;
  fewer.removeRows(std::vector<Index>{0});
  return {.points = fewer};
}

}  // namespace
}  // namespace stipple

STIPPLE_PLUGIN("test operators", "1.0") {
  using namespace stipple;
  registry.add(std::make_unique<Stepper>());
  registry.add(makeOneShot({.id = "mark_limits", .title = "Mark", .region = RegionUse::kLimits}, markInside));
  registry.add(makeOneShot({.id = "mark_mask", .title = "Mark", .region = RegionUse::kMask}, markInside));
  registry.add(makeOneShot({.id = "thin_out", .title = "Thin out"}, removeOddRows));
  registry.add(makeOneShot({.id = "misbehave",
                            .title = "Misbehave",
                            .parameters = {{.id = "how",
                                            .type = ParameterType::kEnum,
                                            .defaultValue = "standard",
                                            .choices = {{"standard", ""},
                                                        {"invalid_input", ""},
                                                        {"number", ""},
                                                        {"memory", ""},
                                                        {"lose_points", ""}}}}},
                           misbehave));
}
