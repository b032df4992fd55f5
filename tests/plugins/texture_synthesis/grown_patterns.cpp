#include "tests/plugins/texture_synthesis/grown_patterns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/geometry/neighborhoods.h"
#include "core/geometry/site_sets.h"

namespace stipple {

namespace {

float quantile(std::vector<float> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

Parameters textureSettings(const Settings& settings) {
  Parameters parameters(makeTextureSynthesis()->description().parameters);
  for (const auto& [id, value] : settings) parameters.set(id, value);
  return parameters;
}

PointSet growPattern(const PointSet& points, const Settings& settings, Report* report) {
  const std::unique_ptr<Run> run = makeTextureSynthesis()->start(points, Region(), textureSettings(settings));
  Progress progress;
  while (!run->step(progress).finished) {
  }
  if (report) *report = run->report();
  return run->result().points;
}

double reported(const Report& report, const std::string& name) {
  for (const auto& [id, value] : report.values) {
    if (id == name) return std::get<double>(value);
  }
  throw InvalidInput("the report has no " + name);
}

int countSpots(const PointSet& points, std::span<const float> values, bool isHigh, int least) {
  const Sites sites = weldAndOrder(points.positions());
  const std::vector<float> field = gatherToSites(sites, values);
  const float middle = 0.5f * (quantile(field, 0.02) + quantile(field, 0.98));
  const auto isInside = [&](Index i) { return isHigh ? field[i] > middle : field[i] < middle; };
  const Neighborhoods neighborhoods = findNeighborhoods(sites, {.k = 8});
  SiteSets sets(sites.size());
  for (Index i = 0; i < sites.size(); ++i) {
    if (!isInside(i)) continue;
    for (const Index j : neighborhoods.of(i)) {
      if (isInside(j)) sets.join(i, j);
    }
  }
  std::map<Index, int> sizes;
  for (Index i = 0; i < sites.size(); ++i) {
    if (isInside(i)) ++sizes[sets.rootOf(i)];
  }
  return static_cast<int>(
      std::count_if(sizes.begin(), sizes.end(), [&](const auto& part) { return part.second >= least; }));
}

double hexagonalDistance(double area, int spots) {
  return std::sqrt(2 * area / (std::sqrt(3) * spots));
}

double stripeDistance(const PointSet& points, std::span<const float> values) {
  const Sites sites = weldAndOrder(points.positions());
  const std::vector<float> field = gatherToSites(sites, values);
  const float middle = quantile(field, 0.5);
  const Neighborhoods neighborhoods = findNeighborhoods(sites, {.k = 8});
  double lengths = 0, crossings = 0;
  for (Index i = 0; i < sites.size(); ++i) {
    for (const Index j : neighborhoods.of(i)) {
      lengths += (sites.positions[i] - sites.positions[j]).norm();
      if ((field[i] > middle) != (field[j] > middle)) ++crossings;
    }
  }
  // Two lines a stripe.
  return 4 * lengths / (std::numbers::pi * crossings);
}

std::vector<Eigen::Vector3f> fibonacciSphere(int count) {
  std::vector<Eigen::Vector3f> points;
  const double turn = std::numbers::pi * (3 - std::sqrt(5));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), angle = turn * i;
    points.push_back(Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>());
  }
  return points;
}

}  // namespace stipple
