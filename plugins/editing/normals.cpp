#include <algorithm>

#include "core/geometry/discretization.h"
#include "core/geometry/moments.h"
#include "core/geometry/orientation.h"
#include "plugins/editing/editing.h"

namespace stipple {

namespace {

// Neighbors of a tangent plane, of a clean scan and at noise of a spacing.
constexpr double kLeastNeighbors = 16, kMostNeighbors = 64;

int neighborsFor(const OneShotInput& input, const Sites& sites) {
  const auto k = static_cast<int>(input.parameters.integer("k"));
  if (k > 0) return std::max(k, 4);
  return static_cast<int>(
      std::clamp(kMostNeighbors * estimateNoise(sites, 16), kLeastNeighbors, kMostNeighbors));
}

RunResult estimateNormals(const OneShotInput& input, Progress& progress, Report& report) {
  PartialProgress preparing(progress, 0, 0.5);
  Discretization d = discretize(input.points, {.consensus = false}, preparing);
  const int k = neighborsFor(input, d.sites);
  progress.report(0.5, "fitting tangent planes");
  const Neighborhoods neighborhoods = findNeighborhoods(d.sites, {.k = k}, &progress);
  const std::vector<Moments> moments = fitMoments(d.sites, neighborhoods, &progress);
  for (Index site = 0; site < d.size(); ++site) {
    const Eigen::Vector3f n = moments[site].axes.col(2);
    if (n.squaredNorm() > 0.5f) d.normals[site] = n;
  }
  progress.report(0.8, "orienting normals");
  PointSet reference = input.points;
  if (!input.parameters.boolean("keep_sides")) reference.erase("normal");
  const Orientation orientation = orientNormals(d, reference, &progress);
  const std::vector<Eigen::Vector3f> normals = scatterToPoints<Eigen::Vector3f>(d.sites, orientation.normals);
  RunResult result{.points = input.points};
  const Attribute* given = result.points.find("normal");
  const bool hasNormals = given && given->type() == AttributeType::kVector3;
  if (!hasNormals) {
    result.points.set("normal", normals);
  } else {
    const std::span<Eigen::Vector3f> written = result.points.edit<Eigen::Vector3f>("normal");
    for (Index row = 0; row < input.points.size(); ++row) {
      if (input.region.contains(row)) written[row] = normals[row];
    }
  }
  report.values = {{"k", static_cast<std::int64_t>(k)},
                   {"votes", static_cast<std::int64_t>(orientation.votes)},
                   {"conflicts", static_cast<std::int64_t>(orientation.conflicts)}};
  return result;
}

RunResult flipNormals(const OneShotInput& input, Progress&, Report&) {
  RunResult result{.points = input.points};
  const Attribute* given = result.points.find("normal");
  if (!given || given->type() != AttributeType::kVector3) throw InvalidInput("there are no normals to flip");
  const std::span<Eigen::Vector3f> normals = result.points.edit<Eigen::Vector3f>("normal");
  for (Index row = 0; row < input.points.size(); ++row) {
    if (input.region.contains(row)) normals[row] = -normals[row];
  }
  return result;
}

}  // namespace

std::unique_ptr<Operator> makeEstimateNormals() {
  return makeOneShot(
      {.id = "estimate_normals",
       .title = "Estimate normals",
       .help = "Normals of the planes through the nearest points, all on one side of the surface.",
       .region = RegionUse::kLimits,
       .parameters = {{.id = "k",
                       .title = "Neighbors",
                       .type = ParameterType::kInt,
                       .defaultValue = std::int64_t{0},
                       .min = 0,
                       .max = 200,
                       .help = "Nearest points that a plane is laid through; 0: 16 to 64, by the noise."},
                      {.id = "keep_sides",
                       .title = "Keep sides",
                       .type = ParameterType::kBool,
                       .defaultValue = true,
                       .help =
                           "Normals that are there decide which side is outside, where they make sense."}},
       .writes = {"normal"}},
      estimateNormals);
}

std::unique_ptr<Operator> makeFlipNormals() {
  return makeOneShot({.id = "flip_normals",
                      .title = "Flip normals",
                      .help = "Turns normals round: the other side is outside.",
                      .region = RegionUse::kLimits,
                      .writes = {"normal"}},
                     flipNormals);
}

}  // namespace stipple
