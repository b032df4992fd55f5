#include "plugins/fairing/fairing_run.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/geometry/fan_normals.h"
#include "core/geometry/orientation.h"
#include "core/points/field.h"
#include "plugins/fairing/resampling.h"

namespace stipple {

namespace {

// Of the step; positions are floats.
constexpr double kTolerance = 1e-7;

bool isNumber(const Attribute& attribute) {
  return attribute.type() != AttributeType::kColor && attribute.type() != AttributeType::kVector3;
}

}  // namespace

FairingRun::FairingRun(PointSet snapshot, Region region, const Parameters& parameters)
    : snapshot_(std::move(snapshot)),
      result_(snapshot_),
      region_(std::move(region)),
      options_(fairingOptions(parameters)),
      rows_(snapshot_.size()) {
  for (Index row = 0; row < snapshot_.size(); ++row) {
    rows_[row].place = rows_[row].firstPlace = snapshot_.positions()[row].cast<double>();
    rows_[row].source = row;
  }
  readWeights();
}

// Points that were added keep the weight that they came with.
void FairingRun::readWeights() {
  const Attribute* attribute = options_.weightBy.empty() ? nullptr : snapshot_.find(options_.weightBy);
  if (!options_.weightBy.empty() && !attribute)
    throw InvalidInput(fmt::format("there is no attribute \"{}\"", options_.weightBy));
  if (attribute && !isNumber(*attribute))
    throw InvalidInput(
        fmt::format("the attribute \"{}\" is no number, weight_by must be one", options_.weightBy));
  for (Row& row : rows_) {
    if (row.source == kAdded) continue;
    const double value = attribute ? readField(*attribute, {&row.source, 1})(0, 0) : 1;
    row.weight = region_.contains(row.source) && std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0;
  }
}

void FairingRun::beginRows(const FairingSurface& surface, const Progress& progress) {
  const Discretization& d = surface.discretization();
  const Orientation orientation = orientNormals(d, snapshot_, &progress);
  const std::vector<double> rest = localSpacings(d);
  const Attribute* given = snapshot_.find("normal");
  std::vector<Eigen::Vector3f> normals(rows_.size());
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Index site = d.sites.siteOfPoint[row];
    normals[row] = rows_[row].normal = rows_[row].firstNormal = orientation.normals[site];
    rows_[row].rest = rest[site];
    rows_[row].isRim = d.fans.open[site];
  }
  if (!given || given->type() != AttributeType::kVector3) result_.set("normal", std::move(normals));
  result_.set("displacement", std::vector<float>(rows_.size(), 0.0f));
  squaredSpacing_ = surface.squaredSpacing();
}

void FairingRun::refresh(Progress& progress) {
  const bool isFirst = squaredSpacing_ == 0;
  if (!isFirst && options_.resamples && surface_) resample(surface_->discretization());
  // Its memory goes before the next one's comes.
  surface_.reset();
  stepper_.reset();
  PartialProgress preparing(progress, 0, isFirst ? 0.9 : 1);
  auto surface = std::make_unique<FairingSurface>(result_, options_, preparing);
  if (isFirst) {
    progress.report(0.9, "orienting normals");
    beginRows(*surface, progress);
  }
  surface_ = std::move(surface);
  stepsOfSurface_ = 0;
}

// The attributes between two rows each: the mean of numbers, vectors and colors; of integers the first's.
PointSet FairingRun::between(const std::vector<std::array<Index, 2>>& parents) const {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Index> first, second, all(parents.size());
  std::iota(all.begin(), all.end(), Index{0});
  for (const auto& [a, b] : parents) {
    positions.push_back((0.5 * (rows_[a].place + rows_[b].place)).cast<float>());
    first.push_back(a);
    second.push_back(b);
  }
  PointSet added(std::move(positions), result_.origin(), result_.positionFileType());
  for (const Attribute& attribute : result_.attributes()) {
    Attribute copy = attribute;
    std::visit(
        [&](const auto& values) {
          std::decay_t<decltype(values)> taken;
          for (const Index row : first) taken.push_back(values[row]);
          copy.column = Column(std::move(taken));
        },
        attribute.column.values());
    const bool isWhole = copy.type() == AttributeType::kInt || copy.type() == AttributeType::kUint;
    if (!isWhole) writeField(copy, all, 0.5 * (readField(attribute, first) + readField(attribute, second)));
    added.insert(std::move(copy));
  }
  return added;
}

void FairingRun::resample(const Discretization& d) {
  std::vector<Index> copies(d.size(), 0);
  for (const Index site : d.sites.siteOfPoint) ++copies[site];
  std::vector<double> rest(d.size(), 0);
  for (Index site = 0; site < d.size(); ++site) {
    const Row& row = rows_[d.sites.pointOfSite[site]];
    if (copies[site] == 1 && !isHeld(row)) rest[site] = row.rest;
  }
  const Resampling plan = planResampling(d, rest);
  std::vector<std::array<Index, 2>> parents;
  for (const auto& [a, b] : plan.inserted)
    parents.push_back({d.sites.pointOfSite[a], d.sites.pointOfSite[b]});
  const PointSet added = between(parents);
  for (const auto& [a, b] : parents) {
    const Row &one = rows_[a], &other = rows_[b];
    rows_.push_back({.place = 0.5 * (one.place + other.place),
                     .firstPlace = 0.5 * (one.firstPlace + other.firstPlace),
                     .normal = (one.normal + other.normal).stableNormalized(),
                     .firstNormal = (one.firstNormal + other.firstNormal).stableNormalized(),
                     .weight = 0.5 * (one.weight + other.weight),
                     .rest = 0.5 * (one.rest + other.rest)});
  }
  if (!parents.empty()) result_.appendRows(added);
  std::vector<Index> removed;
  for (const Index site : plan.removed) removed.push_back(d.sites.pointOfSite[site]);
  std::ranges::sort(removed);
  if (removed.empty()) return;
  result_.removeRows(removed);
  std::size_t kept = 0, next = 0;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (next < removed.size() && removed[next] == row)
      ++next;
    else
      rows_[kept++] = rows_[row];
  }
  rows_.resize(kept);
}

// Sites with a point that must stay.
std::vector<Index> FairingRun::heldSites() const {
  const Discretization& d = surface_->discretization();
  std::vector<std::uint8_t> holds(d.size(), 0);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (isHeld(rows_[row])) holds[d.sites.siteOfPoint[row]] = 1;
  }
  std::vector<Index> held;
  for (Index site = 0; site < d.size(); ++site) {
    // What has no triangles has nothing to follow.
    if (holds[site] || d.fans.of(site).empty() || (options_.pinBoundary && d.fans.open[site]))
      held.push_back(site);
  }
  return held;
}

// Moves what is free along the normals by as much as the motion lost, so that their flux is 0.
void FairingRun::keepVolume(Eigen::MatrixXd& motion, const std::vector<Index>& held) const {
  const Discretization& d = surface_->discretization();
  std::vector<std::uint8_t> holds(d.size(), 0);
  for (const Index site : held) holds[site] = 1;
  const auto normalOf = [&](Index site) -> Eigen::RowVector3d {
    return rows_[d.sites.pointOfSite[site]].normal.cast<double>().transpose();
  };
  double flux = 0, area = 0;
  for (Index site = 0; site < d.size(); ++site) {
    if (holds[site]) continue;
    flux += d.mass[site] * normalOf(site).dot(motion.row(site));
    area += d.mass[site];
  }
  if (!(area > 0)) return;
  for (Index site = 0; site < d.size(); ++site) {
    if (!holds[site]) motion.row(site) -= flux / area * normalOf(site);
  }
}

// The motion of the sites in one step.
Eigen::MatrixXd FairingRun::solve(const std::vector<Index>& held, const Progress& progress) {
  const Discretization& d = surface_->discretization();
  if (!stepper_) {
    stepper_ = std::make_unique<DiffusionStepper>(
        surface_->stiffness(), d.mass,
        DiffusionOptions{.timeStep = options_.timeStep * squaredSpacing_,
                         .held = held,
                         .solver = {.tolerance = kTolerance, .expectedSolves = 3 * options_.refresh}},
        &progress);
  }
  // About the first site, so that the tolerance is one of shapes, not of places.
  const Eigen::Vector3d center = rows_[d.sites.pointOfSite[0]].place;
  Eigen::MatrixXd places(d.size(), 3);
  for (Index site = 0; site < d.size(); ++site)
    places.row(site) = (rows_[d.sites.pointOfSite[site]].place - center).transpose();
  Eigen::MatrixXd motion = places;
  stepper_->step(motion, &progress);
  motion -= places;
  if (!motion.allFinite()) throw InvalidInput("the step is too large for these points");
  return motion;
}

// The motion of this step, on a surface made anew where it is time; leaves all as it was where it fails.
Eigen::MatrixXd FairingRun::findMotion(Progress& progress) {
  const bool isDue = !surface_ || stepsOfSurface_ >= options_.refresh;
  const PointSet result = result_;
  const std::vector<Row> rows = isDue ? rows_ : std::vector<Row>();
  const double squaredSpacing = squaredSpacing_;
  try {
    if (isDue) {
      PartialProgress preparing(progress, 0, 0.8);
      refresh(preparing);
    }
    const std::vector<Index> held = heldSites();
    Eigen::MatrixXd motion = solve(held, progress);
    if (options_.keepVolume) keepVolume(motion, held);
    return motion;
  } catch (...) {
    result_ = result;
    squaredSpacing_ = squaredSpacing;
    if (isDue) rows_ = rows;
    surface_.reset();
    stepper_.reset();
    throw;
  }
}

StepState FairingRun::step(Progress& progress) {
  if (steps_ >= options_.steps) return {};
  const Eigen::MatrixXd motion = findMotion(progress);
  const double change = move(motion);
  write();
  ++steps_;
  ++stepsOfSurface_;
  time_ += options_.timeStep * squaredSpacing_;
  const double fraction = static_cast<double>(steps_) / options_.steps;
  progress.report(fraction, "fairing");
  return {.finished = steps_ >= options_.steps, .fraction = std::min(fraction, 1.0), .curve = change};
}

// Returns the mean motion in spacings.
double FairingRun::move(const Eigen::MatrixXd& motion) {
  const Sites& sites = surface_->discretization().sites;
  double sum = 0;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Eigen::Vector3d step = rows_[row].weight * motion.row(sites.siteOfPoint[row]).transpose();
    rows_[row].place += step;
    sum += step.squaredNorm();
  }
  const double count = std::max<double>(static_cast<double>(rows_.size()), 1);
  return std::sqrt(sum / count / std::max(squaredSpacing_, 1e-300));
}

// Rows that have not moved keep what they have.
void FairingRun::write() {
  const Sites& sites = surface_->discretization().sites;
  Eigen::MatrixXd places(sites.size(), 3);
  std::vector<Eigen::Vector3f> along(sites.size());
  for (Index site = 0; site < sites.size(); ++site) {
    places.row(site) = rows_[sites.pointOfSite[site]].place.transpose();
    along[site] = rows_[sites.pointOfSite[site]].normal;
  }
  const std::vector<Eigen::Vector3f> normals = fanNormals(surface_->discretization().fans, places, along);
  const std::span<Eigen::Vector3f> positions = result_.editPositions();
  const std::span<Eigen::Vector3f> written = result_.edit<Eigen::Vector3f>("normal");
  const std::span<float> displacement = result_.edit<float>("displacement");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    const Eigen::Vector3d motion = row.place - row.firstPlace;
    if (motion.isZero(0)) continue;
    row.normal = normals[sites.siteOfPoint[i]];
    positions[i] = row.place.cast<float>();
    written[i] = row.normal;
    displacement[i] = static_cast<float>(motion.dot(row.firstNormal.cast<double>()));
  }
}

void FairingRun::set(const Parameters& parameters) {
  const FairingOptions before = std::exchange(options_, fairingOptions(parameters));
  try {
    readWeights();
  } catch (...) {
    options_ = before;
    throw;
  }
  // The next step makes everything anew that a parameter may have changed.
  stepsOfSurface_ = std::numeric_limits<int>::max();
}

RunResult FairingRun::result() const {
  RunResult result{.points = result_};
  Index next = 0;
  for (const Row& row : rows_) {
    if (row.source == kAdded) break;
    while (next < row.source) result.removedRows.push_back(next++);
    ++next;
  }
  while (next < snapshot_.size()) result.removedRows.push_back(next++);
  return result;
}

Report FairingRun::report() const {
  Report report;
  report.values = {{"diffusion_steps", static_cast<std::int64_t>(steps_)}, {"time", time_}};
  if (!surface_) return report;
  report.values.push_back({"spacing", std::sqrt(squaredSpacing_)});
  report.values.push_back({"noise", surface_->noise()});
  report.values.push_back({"k", static_cast<std::int64_t>(surface_->neighbors())});
  if (options_.resamples) report.values.push_back({"points", static_cast<std::int64_t>(rows_.size())});
  return report;
}

}  // namespace stipple
