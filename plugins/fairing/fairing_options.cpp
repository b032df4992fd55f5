#include "plugins/fairing/fairing_options.h"

#include <algorithm>

#include "plugins/api/fe_parameters.h"

namespace stipple {

std::vector<Parameter> fairingParameters() {
  // The choices stand in the order of FairingTensor.
  std::vector<Parameter> parameters = withFeParameters(
      {{.id = "steps",
        .title = "Steps",
        .type = ParameterType::kInt,
        .defaultValue = std::int64_t{8},
        .min = 1,
        .max = 100000,
        .help = "Steps of diffusion. Steps times time step says how much is smoothed: 1 h^2 for noise of .15 "
                "spacings, 2 for .3."},
       {.id = "time_step",
        .title = "Time step",
        .unit = Unit::kSpacingSquared,
        .defaultValue = 0.25,
        .min = 1e-4,
        .max = 1000,
        .help = "Time of one step; h is the mean spacing."},
       {.id = "tensor",
        .title = "Tensor",
        .type = ParameterType::kEnum,
        .defaultValue = "features",
        .choices = {{"features", "Keep creases and corners"},
                    {"paper", "Keep creases"},
                    {"isotropic", "Isotropic"}},
        .help = "features: nothing flows across creases, nor at corners along them. paper: A = diag(1, C). "
                "isotropic: mean curvature flow."},
       {.id = "crease_angle",
        .title = "Crease angle",
        .unit = Unit::kAngle,
        .defaultValue = 45.0,
        .min = 10,
        .max = 120,
        .help = "Creases that turn by more are kept (tensor features)."},
       {.id = "k",
        .title = "Neighbors",
        .type = ParameterType::kInt,
        .defaultValue = std::int64_t{0},
        .min = 0,
        .max = 200,
        .help = "Neighbors that the classifier looks at; 0: 60, up to 120 where the scan is noisy."},
       {.id = "refresh",
        .title = "Refresh",
        .type = ParameterType::kInt,
        .defaultValue = std::int64_t{2},
        .min = 1,
        .max = 100,
        .help = "Neighborhoods, normals, classifier and matrix are made anew every so many steps."},
       {.id = "pin_boundary",
        .title = "Pin boundary",
        .type = ParameterType::kBool,
        .defaultValue = true,
        .help = "Points on the rim of the surface, and of holes in it, stay."},
       {.id = "volume",
        .title = "Keep volume",
        .type = ParameterType::kBool,
        .defaultValue = false,
        .help = "After each step the surface moves along its normals so that no volume is lost."},
       {.id = "resample",
        .title = "Resample",
        .type = ParameterType::kBool,
        .defaultValue = false,
        .help = "Points are inserted where the surface stretches and removed where it shrinks."},
       {.id = "weight_by",
        .title = "Weight",
        .type = ParameterType::kAttribute,
        .defaultValue = "none",
        .choices = {{"none", "Everywhere alike"}},
        .help = "A number from 0 to 1 that scales how far each point moves."}});
  // Unfolded distances are longer the noisier the scan is, and what is faired is noisy.
  std::ranges::find(parameters, "metric", &Parameter::id)->defaultValue = "projected";
  return parameters;
}

FairingOptions fairingOptions(const Parameters& parameters) {
  const std::string& weight = parameters.text("weight_by");
  return {.steps = static_cast<int>(parameters.integer("steps")),
          .timeStep = parameters.number("time_step"),
          .tensor = parameters.choice<FairingTensor>("tensor"),
          .creaseAngle = parameters.number("crease_angle"),
          .k = static_cast<int>(parameters.integer("k")),
          .refresh = static_cast<int>(parameters.integer("refresh")),
          .pinBoundary = parameters.boolean("pin_boundary"),
          .keepVolume = parameters.boolean("volume"),
          .resamples = parameters.boolean("resample"),
          .weightBy = weight == "none" ? "" : weight,
          .discretization = discretizationOptions(parameters)};
}

}  // namespace stipple
