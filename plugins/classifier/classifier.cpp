#include "plugins/classifier/classifier.h"

#include "core/geometry/moments.h"

namespace stipple {

namespace {

OperatorDescription describe() {
  return {
      .id = "classifier",
      .title = "Classifier",
      .help =
          "Tells creases from flat places: 1 where the surface is flat within the neighborhood, small at "
          "creases.",
      .parameters = {{.id = "k",
                      .title = "Neighbors",
                      .type = ParameterType::kInt,
                      .defaultValue = std::int64_t{30},
                      .min = 4,
                      .max = 200,
                      .help = "Nearest points that are looked at; more for noisy scans and wider features."},
                     {.id = "epsilon",
                      .title = "Radius",
                      .type = ParameterType::kFloat,
                      .unit = Unit::kLength,
                      .defaultValue = 0.0,
                      .min = 0,
                      .help = "All points within this distance too, where the nearest ones lie closer."}},
      .writes = {"classifier"}};
}

RunResult run(const OneShotInput& input, Progress& progress, Report&) {
  const Sites sites = weldAndOrder(input.points.positions());
  const NeighborhoodOptions options = {.k = static_cast<int>(input.parameters.integer("k")),
                                       .epsilon = static_cast<float>(input.parameters.number("epsilon"))};
  progress.report(0, "neighbors");
  const Neighborhoods neighborhoods = findNeighborhoods(sites, options, &progress);
  progress.report(0.7, "moments");
  const std::vector<float> classifier = classify(fitMoments(sites, neighborhoods, &progress));
  RunResult result{.points = input.points};
  result.points.set("classifier", scatterToPoints<float>(sites, classifier));
  return result;
}

}  // namespace

std::unique_ptr<Operator> makeClassifier() {
  return makeOneShot(describe(), run);
}

}  // namespace stipple
