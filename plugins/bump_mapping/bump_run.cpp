#include "plugins/bump_mapping/bump_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/fem/gradient.h"
#include "core/geometry/orientation.h"
#include "core/points/field.h"
#include "plugins/api/fe_parameters.h"
#include "plugins/bump_mapping/radial_gradient.h"

namespace stipple {

namespace {

constexpr double kSteepQuantile = 0.95;

const Attribute& requireNumber(const PointSet& points, const std::string& name) {
  const Attribute* found = points.find(name);
  if (!found) throw InvalidInput(fmt::format("there is no attribute \"{}\"", name));
  if (channelsOf(found->type()) != 1)
    throw InvalidInput(
        fmt::format("attribute \"{}\" is a {}, expected a number", name, nameOf(found->type())));
  return *found;
}

// The normals of the file in the sense of the surface; those of the surface where there are none.
std::vector<Eigen::Vector3f> baseNormals(const PointSet& points, const Sites& sites,
                                         std::span<const Eigen::Vector3f> oriented) {
  const Attribute* given = points.find("normal");
  const bool isGiven = given && given->type() == AttributeType::kVector3;
  std::vector<Eigen::Vector3f> normals(points.size());
  for (Index row = 0; row < points.size(); ++row) {
    const Eigen::Vector3f& ofSurface = oriented[sites.siteOfPoint[row]];
    normals[row] = ofSurface;
    if (!isGiven) continue;
    const Eigen::Vector3f normal = given->column.view<Eigen::Vector3f>()[row].stableNormalized();
    if (!normal.allFinite() || !(normal.squaredNorm() > 0)) continue;
    normals[row] = normal.dot(ofSurface) < 0 ? Eigen::Vector3f(-normal) : normal;
  }
  return normals;
}

double steepOf(std::span<const Eigen::Vector3d> gradients) {
  if (gradients.empty()) return 0;
  std::vector<double> lengths;
  for (const Eigen::Vector3d& gradient : gradients) lengths.push_back(gradient.norm());
  std::ranges::sort(lengths);
  const double quantile =
      lengths[static_cast<std::size_t>(kSteepQuantile * static_cast<double>(lengths.size() - 1))];
  return quantile > 0 ? quantile : lengths.back();
}

}  // namespace

BumpRun::BumpRun(PointSet snapshot, const Parameters& parameters)
    : snapshot_(std::move(snapshot)), result_(snapshot_), parameters_(parameters) {
  requireNumber(snapshot_, parameters_.text("attribute"));
}

BumpRun::Relief BumpRun::measure(Progress& progress) const {
  PartialProgress discretizing(progress, 0, 0.6);
  const Discretization d = discretize(snapshot_, discretizationOptions(parameters_), discretizing);
  progress.report(0.6, "orienting normals");
  const Orientation orientation = orientNormals(d, snapshot_, &progress);
  progress.report(0.8, "gradients");
  const Eigen::VectorXd read =
      readField(requireNumber(snapshot_, parameters_.text("attribute")), d.sites.pointOfSite);
  const std::vector<double> values(read.begin(), read.end());
  double radius = parameters_.number("radius");
  if (!(radius > 0)) {
    const double area = std::accumulate(d.mass.begin(), d.mass.end(), 0.0);
    radius = 2 * std::sqrt(area / std::max<double>(d.size(), 1));
  }
  const bool isFan = parameters_.choice<GradientMethod>("gradient") == GradientMethod::kFan;
  std::vector<Eigen::Vector3d> gradients =
      isFan ? fanGradient(d, values, &progress) : radialGradient(d, values, radius, &progress);
  for (Eigen::Vector3d& gradient : gradients) {
    if (!gradient.allFinite()) gradient.setZero();
  }
  return {.normals = baseNormals(snapshot_, d.sites, orientation.normals),
          .gradients = scatterToPoints<Eigen::Vector3d>(d.sites, gradients),
          .steep = steepOf(gradients)};
}

StepState BumpRun::step(Progress& progress) {
  if (!relief_) relief_ = std::make_unique<const Relief>(measure(progress));
  Report report;
  report.values = {{"steepness", relief_->steep}};
  if (!(relief_->steep > 0))
    report.warnings.push_back(fmt::format("attribute \"{}\" is the same everywhere: there is no relief",
                                          parameters_.text("attribute")));
  const bool isScaled = parameters_.boolean("normalize") && relief_->steep > 0;
  const double strength = parameters_.number("strength") / (isScaled ? relief_->steep : 1);
  std::vector<Eigen::Vector3f> tilted = relief_->normals;
  for (Index row = 0; row < tilted.size(); ++row) {
    const Eigen::Vector3d normal = tilted[row].cast<double>() - strength * relief_->gradients[row];
    tilted[row] = normal.stableNormalized().cast<float>();
  }
  PointSet points = snapshot_;
  if (parameters_.boolean("bake")) points.set("normal", tilted);
  points.set("display_normal", std::move(tilted));
  result_ = std::move(points);
  report_ = std::move(report);
  return {};
}

void BumpRun::set(const Parameters& parameters) {
  for (const Parameter& parameter : parameters.declared()) {
    const bool isCheap = parameter.id == "strength" || parameter.id == "normalize" || parameter.id == "bake";
    if (isCheap || parameters.value(parameter.id) == parameters_.value(parameter.id)) continue;
    *this = BumpRun(std::move(snapshot_), parameters);
    return;
  }
  parameters_ = parameters;
}

}  // namespace stipple
