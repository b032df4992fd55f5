#include "plugins/bump_mapping/bump_mapping.h"

#include "plugins/api/fe_parameters.h"
#include "plugins/bump_mapping/bump_run.h"

namespace stipple {

namespace {

std::vector<Parameter> bumpParameters() {
  // The choices stand in the order of GradientMethod.
  return withFeParameters(
      {{.id = "attribute",
        .title = "Height",
        .type = ParameterType::kAttribute,
        .defaultValue = "species_a",
        .help = "The number a whose gradient tilts the normals, such as a synthesized texture."},
       {.id = "strength",
        .title = "Strength",
        .defaultValue = 0.5,
        .min = -10,
        .max = 10,
        .help = "K: bumps stand out where the number is high, below 0 they are dents. .1 is faint, 1 is "
                "strong (6 and 45 degrees)."},
       {.id = "gradient",
        .title = "Gradient",
        .type = ParameterType::kEnum,
        .defaultValue = "fan",
        .choices = {{"fan", "Fans"}, {"radial", "Radial basis"}},
        .help = "fan: mean over the triangles of the fan. radial: of a(x) = sum a(q) w(|x - q| / d) / sum "
                "w(|x - q| / d), softer the larger the radius d."},
       {.id = "radius",
        .title = "Radius",
        .unit = Unit::kLength,
        .defaultValue = 0.0,
        .min = 0,
        .help = "d of the radial basis; 0: twice the spacing of the points."},
       {.id = "normalize",
        .title = "Normalize",
        .type = ParameterType::kBool,
        .defaultValue = true,
        .help = "Take the gradient in units of the one that a twentieth of the points exceed, so that the "
                "strength means the same on any scan; off: per model unit."},
       {.id = "bake",
        .title = "Bake",
        .type = ParameterType::kBool,
        .defaultValue = false,
        .help = "Write the tilted normals to normal, too."}});
}

class BumpMapping final : public Operator {
 public:
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region, const Parameters& parameters) const override {
    return std::make_unique<BumpRun>(std::move(snapshot), parameters);
  }

 private:
  OperatorDescription description_ = {
      .id = "bump_mapping",
      .title = "Bump mapping",
      .help =
          "Makes a number look like relief: shows the surface with the normals n - K grad a, of unit length.",
      .parameters = bumpParameters(),
      .writes = {"display_normal", "normal"}};
};

}  // namespace

std::unique_ptr<Operator> makeBumpMapping() {
  return std::make_unique<BumpMapping>();
}

}  // namespace stipple
