// A plugin as a stranger would write it: moves the points of a region up, by a finite-element average of the
// region.

#include "core/fem/point_rows.h"
#include "core/geometry/discretization.h"
#include "plugins/api/fe_parameters.h"
#include "plugins/api/plugin.h"

namespace {

using namespace stipple;

// The area of the region, by the mass matrix.
double areaOf(const OneShotInput& input, Progress& progress) {
  const Discretization d = discretize(input.points, discretizationOptions(input.parameters), progress);
  const std::vector<double> mass = expandMassToPoints(d.sites, d.mass);
  double area = 0;
  for (const Index row : input.region.rows(input.points.size())) area += mass[row];
  return area;
}

RunResult lift(const OneShotInput& input, Progress& progress, Report& report) {
  RunResult result{.points = input.points};
  const auto by = static_cast<float>(input.parameters.number("by"));
  const auto positions = result.points.editPositions();
  for (const Index row : input.region.rows(input.points.size())) positions[row].z() += by;
  report.values.emplace_back("area", areaOf(input, progress));
  return result;
}

}  // namespace

STIPPLE_PLUGIN("lift", "1.0") {
  registry.add(makeOneShot({.id = "lift",
                            .title = "Lift",
                            .help = "Moves points up.",
                            .region = RegionUse::kLimits,
                            .parameters = withFeParameters(
                                {{.id = "by", .title = "By", .unit = Unit::kLength, .defaultValue = 1.0}}),
                            .writes = {"position"}},
                           lift));
}
