#include "plugins/api/fe_parameters.h"

namespace stipple {

std::vector<Parameter> withFeParameters(std::vector<Parameter> own) {
  // The choices stand in the order of the enumerations Scheme and Metric.
  own.push_back(
      {.id = "scheme",
       .title = "Scheme",
       .type = ParameterType::kEnum,
       .defaultValue = "voronoi",
       .choices = {{"voronoi", "Voronoi"}, {"element", "Elements"}, {"paper", "Paper"}, {"mesh", "Mesh"}},
       .help = "How matrices come from the points; mesh: from the triangles of the file."});
  own.push_back({.id = "metric",
                 .title = "Metric",
                 .type = ParameterType::kEnum,
                 .defaultValue = "unfolded",
                 .choices = {{"unfolded", "Unfolded"}, {"projected", "Projected"}},
                 .help = "Neighbors at their distance in space, or projected; projected suits noisy scans."});
  own.push_back(
      {.id = "consensus",
       .title = "Consensus",
       .type = ParameterType::kBool,
       .defaultValue = true,
       .help = "Bring neighboring fans to agreement where they can; off: everything is purely local."});
  return own;
}

DiscretizationOptions discretizationOptions(const Parameters& parameters) {
  return {.scheme = parameters.choice<Scheme>("scheme"),
          .metric = parameters.choice<Metric>("metric"),
          .consensus = parameters.boolean("consensus")};
}

}  // namespace stipple
