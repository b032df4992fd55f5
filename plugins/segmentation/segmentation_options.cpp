#include "plugins/segmentation/segmentation_options.h"

#include "plugins/api/fe_parameters.h"

namespace stipple {

std::vector<Parameter> segmentationParameters() {
  // The choices stand in the order of the enumerations.
  return withFeParameters(
      {{.id = "seeds",
        .title = "Seeds",
        .type = ParameterType::kAttribute,
        .defaultValue = "auto",
        .choices = {{"auto", "Automatic"}},
        .help = "A whole-number attribute with the label of each seed point, 0 elsewhere; or found "
                "automatically."},
       {.id = "crease_angle",
        .title = "Crease angle",
        .unit = Unit::kAngle,
        .defaultValue = 45.0,
        .min = 5,
        .max = 170,
        .help = "Creases where the surface turns by more than this are sealed."},
       {.id = "fill",
        .title = "Fill",
        .type = ParameterType::kBool,
        .defaultValue = false,
        .help = "Give points left over the nearest label along the surface."},
       {.id = "k",
        .title = "Neighbors",
        .type = ParameterType::kInt,
        .defaultValue = std::int64_t{0},
        .min = 0,
        .max = 200,
        .help = "Points looked at to find creases; 0: from the noise of the scan."},
       {.id = "diffusivity",
        .title = "Diffusivity",
        .type = ParameterType::kEnum,
        .defaultValue = "blocking",
        .choices = {{"blocking", "Blocked at creases"}, {"classifier", "Classifier"}},
        .help = "blocking: nothing crosses a sealed crease. classifier: slow near creases, as in the paper."},
       {.id = "steps",
        .title = "Steps",
        .type = ParameterType::kInt,
        .defaultValue = std::int64_t{200},
        .min = 1,
        .max = 100000,
        .help = "At most this many diffusion steps, for each seed where they are automatic; it ends when "
                "nothing grows."},
       {.id = "time_step",
        .title = "Time step",
        .unit = Unit::kDiagonalSquared,
        .defaultValue = 4e-4,
        .min = 1e-8,
        .max = 1,
        .help = "Time of one diffusion step."},
       {.id = "threshold",
        .title = "Threshold",
        .defaultValue = 0.5,
        .min = 0.02,
        .max = 0.99,
        .help = "A point belongs to the first label whose signal exceeds this."},
       {.id = "seeding",
        .title = "Seeding",
        .type = ParameterType::kEnum,
        .defaultValue = "farthest",
        .choices = {{"farthest", "Farthest"}, {"flattest", "Flattest"}},
        .help = "Automatic seeds lie farthest from creases and labels, or at the flattest point."}});
}

SegmentationOptions readSegmentationOptions(const Parameters& parameters) {
  return {.discretization = discretizationOptions(parameters),
          .seeds = parameters.text("seeds"),
          .creaseAngle = parameters.number("crease_angle"),
          .fill = parameters.boolean("fill"),
          .k = static_cast<int>(parameters.integer("k")),
          .diffusivity = parameters.choice<Diffusivity>("diffusivity"),
          .steps = static_cast<int>(parameters.integer("steps")),
          .timeStep = parameters.number("time_step"),
          .threshold = parameters.number("threshold"),
          .seeding = parameters.choice<Seeding>("seeding")};
}

}  // namespace stipple
