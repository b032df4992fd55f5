#include "plugins/fairing/fairing_run.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/orientation.h"
#include "core/points/field.h"

namespace stipple {

namespace {

// Of the step; positions are floats.
constexpr double kTolerance = 1e-7;

std::vector<double> readWeights(const PointSet& points, const std::string& name) {
  if (name.empty()) return {};
  const Attribute* attribute = points.find(name);
  if (!attribute) throw InvalidInput(fmt::format("there is no attribute \"{}\"", name));
  const bool isNumber =
      attribute->type() != AttributeType::kColor && attribute->type() != AttributeType::kVector3;
  if (!isNumber)
    throw InvalidInput(fmt::format("the attribute \"{}\" is no number, weight_by must be one", name));
  std::vector<Index> rows(points.size());
  for (Index row = 0; row < points.size(); ++row) rows[row] = row;
  const Eigen::MatrixXd values = readField(*attribute, rows);
  std::vector<double> weights(points.size());
  for (Index row = 0; row < points.size(); ++row) {
    const double value = values(row, 0);
    weights[row] = std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
  }
  return weights;
}

std::vector<Eigen::Vector3f> gather(const Sites& sites, const std::vector<Eigen::Vector3f>& ofRows) {
  return gatherToSites<Eigen::Vector3f>(sites, ofRows);
}

}  // namespace

FairingRun::FairingRun(PointSet snapshot, Region region, const Parameters& parameters)
    : snapshot_(std::move(snapshot)),
      result_(snapshot_),
      region_(std::move(region)),
      options_(fairingOptions(parameters)),
      weights_(readWeights(snapshot_, options_.weightBy)) {
  rows_.reserve(snapshot_.size());
  for (const Eigen::Vector3f& p : snapshot_.positions()) rows_.push_back(p.cast<double>());
}

void FairingRun::refresh(Progress& progress) {
  auto surface = std::make_unique<FairingSurface>(result_, options_, progress);
  const Discretization& d = surface->discretization();
  if (firstNormals_.empty()) {
    progress.report(0.9, "orienting normals");
    const Orientation orientation = orientNormals(d, snapshot_, &progress);
    firstNormals_ = scatterToPoints<Eigen::Vector3f>(d.sites, orientation.normals);
    normals_ = firstNormals_;
    squaredSpacing_ = surface->squaredSpacing();
    isRim_ = scatterToPoints<std::uint8_t>(d.sites, d.fans.open);
  }
  surface_ = std::move(surface);
  stepper_.reset();
  stepsOfSurface_ = 0;
}

// Sites with a point that must stay.
std::vector<Index> FairingRun::heldSites() const {
  const Discretization& d = surface_->discretization();
  std::vector<std::uint8_t> isHeld(d.size(), 0);
  for (Index row = 0; row < snapshot_.size(); ++row) {
    if (!region_.contains(row) || (options_.pinBoundary && isRim_[row]) ||
        (!weights_.empty() && weights_[row] == 0))
      isHeld[d.sites.siteOfPoint[row]] = 1;
  }
  std::vector<Index> held;
  for (Index site = 0; site < d.size(); ++site) {
    // What has no triangles has nothing to follow.
    if (isHeld[site] || d.fans.of(site).empty() || (options_.pinBoundary && d.fans.open[site]))
      held.push_back(site);
  }
  return held;
}

// Moves what is free along the normals by as much as the motion lost, so that their flux is 0.
void FairingRun::keepVolume(Eigen::MatrixXd& motion, const std::vector<Index>& held) const {
  const Discretization& d = surface_->discretization();
  const std::vector<Eigen::Vector3f> normals = gather(d.sites, normals_);
  std::vector<std::uint8_t> isHeld(d.size(), 0);
  for (const Index site : held) isHeld[site] = 1;
  double flux = 0, area = 0;
  for (Index site = 0; site < d.size(); ++site) {
    if (isHeld[site]) continue;
    flux += d.mass[site] * normals[site].cast<double>().dot(motion.row(site));
    area += d.mass[site];
  }
  if (!(area > 0)) return;
  for (Index site = 0; site < d.size(); ++site) {
    if (!isHeld[site]) motion.row(site) -= flux / area * normals[site].cast<double>().transpose();
  }
}

StepState FairingRun::step(Progress& progress) {
  if (steps_ >= options_.steps) return {};
  if (!surface_ || stepsOfSurface_ >= options_.refresh) {
    PartialProgress preparing(progress, 0, 0.8);
    refresh(preparing);
  }
  const Discretization& d = surface_->discretization();
  const std::vector<Index> held = heldSites();
  const double tau = options_.timeStep * squaredSpacing_;
  if (!stepper_) {
    stepper_ = std::make_unique<DiffusionStepper>(
        surface_->stiffness(), d.mass,
        DiffusionOptions{.timeStep = tau,
                         .held = held,
                         .solver = {.tolerance = kTolerance, .expectedSolves = 3 * options_.refresh}},
        &progress);
  }
  // About the first site, so that the tolerance is one of shapes, not of places.
  const Eigen::RowVector3d center = rows_[d.sites.pointOfSite[0]].transpose();
  Eigen::MatrixXd places(d.size(), 3);
  for (Index site = 0; site < d.size(); ++site)
    places.row(site) = rows_[d.sites.pointOfSite[site]].transpose() - center;
  Eigen::MatrixXd motion = places;
  stepper_->step(motion, &progress);
  motion -= places;
  if (!motion.allFinite()) throw InvalidInput("the step is too large for these points");
  if (options_.keepVolume) keepVolume(motion, held);
  const double change = move(motion);
  ++steps_;
  ++stepsOfSurface_;
  time_ += tau;
  const double fraction = static_cast<double>(steps_) / options_.steps;
  progress.report(fraction, "fairing");
  return {.finished = steps_ >= options_.steps, .fraction = std::min(fraction, 1.0), .curve = change};
}

// Returns the mean motion in spacings.
double FairingRun::move(const Eigen::MatrixXd& motion) {
  const Sites& sites = surface_->discretization().sites;
  double sum = 0;
  for (Index row = 0; row < snapshot_.size(); ++row) {
    if (!region_.contains(row)) continue;
    const double weight = weights_.empty() ? 1 : weights_[row];
    const Eigen::Vector3d step = weight * motion.row(sites.siteOfPoint[row]).transpose();
    rows_[row] += step;
    sum += step.squaredNorm();
  }
  Eigen::MatrixXd places(sites.size(), 3);
  for (Index site = 0; site < sites.size(); ++site)
    places.row(site) = rows_[sites.pointOfSite[site]].transpose();
  write(places);
  return std::sqrt(sum / std::max<double>(snapshot_.size(), 1) / std::max(squaredSpacing_, 1e-300));
}

void FairingRun::write(const Eigen::MatrixXd& places) {
  const Sites& sites = surface_->discretization().sites;
  const std::vector<Eigen::Vector3f> normals = surface_->normalsAt(places, gather(sites, normals_));
  const Attribute* given = snapshot_.find("normal");
  const bool hasNormals = given && given->type() == AttributeType::kVector3;
  std::vector<Eigen::Vector3f> written(snapshot_.size());
  std::vector<float> displacement(snapshot_.size(), 0);
  const std::span<Eigen::Vector3f> positions = result_.editPositions();
  const std::span<const Eigen::Vector3f> first = snapshot_.positions();
  for (Index row = 0; row < snapshot_.size(); ++row) {
    normals_[row] = normals[sites.siteOfPoint[row]];
    const Eigen::Vector3d motion = rows_[row] - first[row].cast<double>();
    const bool hasMoved = region_.contains(row) && !motion.isZero(0);
    if (hasMoved) positions[row] = rows_[row].cast<float>();
    written[row] = !hasMoved && hasNormals ? given->column.view<Eigen::Vector3f>()[row] : normals_[row];
    displacement[row] = static_cast<float>(motion.dot(firstNormals_[row].cast<double>()));
  }
  result_.set("normal", std::move(written));
  result_.set("displacement", std::move(displacement));
}

void FairingRun::set(const Parameters& parameters) {
  const FairingOptions fresh = fairingOptions(parameters);
  weights_ = readWeights(snapshot_, fresh.weightBy);
  options_ = fresh;
  // The next step makes everything anew that a parameter may have changed.
  surface_.reset();
}

Report FairingRun::report() const {
  Report report;
  report.values = {{"diffusion_steps", static_cast<std::int64_t>(steps_)}, {"time", time_}};
  if (!surface_) return report;
  report.values.push_back({"spacing", std::sqrt(squaredSpacing_)});
  report.values.push_back({"noise", surface_->noise()});
  report.values.push_back({"k", static_cast<std::int64_t>(surface_->neighbors())});
  return report;
}

}  // namespace stipple
