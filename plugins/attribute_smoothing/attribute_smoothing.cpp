#include "plugins/attribute_smoothing/attribute_smoothing.h"

#include "plugins/api/fe_parameters.h"
#include "plugins/attribute_smoothing/smoothing_run.h"

namespace stipple {

namespace {

std::vector<Parameter> smoothingParameters() {
  // The choices stand in the order of SmoothingMethod.
  return withFeParameters(
      {{.id = "attribute",
        .title = "Attribute",
        .type = ParameterType::kAttribute,
        .defaultValue = "color",
        .help = "What is smoothed: colors (in linear light), numbers or vectors."},
       {.id = "method",
        .title = "Method",
        .type = ParameterType::kEnum,
        .defaultValue = "heat",
        .choices = {{"heat", "Heat equation"}, {"edge_preserving", "Edge preserving"}},
        .help = "heat: du/dt = div(grad u). edge_preserving: du/dt = div(g grad u), g = exp(-|grad u|^2 / "
                "s^2), s the gradient that an eighth of the points exceed"},
       {.id = "steps",
        .title = "Steps",
        .type = ParameterType::kInt,
        .defaultValue = std::int64_t{10},
        .min = 1,
        .max = 100000,
        .help = "Steps of diffusion."},
       {.id = "time_step",
        .title = "Time step",
        .unit = Unit::kSpacingSquared,
        .defaultValue = 0.25,
        .min = 1e-4,
        .max = 1e6,
        .help = "Time of one step; details of size s are gone after a time of about s^2."},
       {.id = "block_creases",
        .title = "Block creases",
        .type = ParameterType::kBool,
        .defaultValue = false,
        .help = "Nothing flows across creases sharper than 45 degrees."}});
}

class AttributeSmoothing final : public Operator {
 public:
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region region, const Parameters& parameters) const override {
    return std::make_unique<SmoothingRun>(std::move(snapshot), std::move(region), parameters);
  }

 private:
  OperatorDescription description_ = {
      .id = "attribute_smoothing",
      .title = "Attribute smoothing",
      .help =
          "Smooths an attribute along the surface by diffusion: du/dt = div(A grad u), in implicit steps "
          "(M + tau L) u' = M u.",
      .region = RegionUse::kLimits,
      .parameters = smoothingParameters(),
      .writes = {"<attribute>"}};
};

}  // namespace

std::unique_ptr<Operator> makeAttributeSmoothing() {
  return std::make_unique<AttributeSmoothing>();
}

}  // namespace stipple
