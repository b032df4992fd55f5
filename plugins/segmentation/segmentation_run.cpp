#include "plugins/segmentation/segmentation_run.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "plugins/segmentation/seeds.h"
#include "plugins/segmentation/surface_distance.h"

namespace stipple {

namespace {

// A label is done when a step adds less than this share of what it has.
constexpr double kStandstill = 1e-3;
// No seed nearer than this to a crease or a label: there is no room for a face of its own.
constexpr double kRoomInSpacings = 2;
// A piece that is sealed off gets a label of its own from this many sites on, however narrow it is.
constexpr std::size_t kSmallestPiece = 50;
// A disc of this many diffusion lengths survives an implicit step at u = 1.
constexpr double kDiscInDiffusionLengths = 2;
// Steps that one automatic seed usually takes: what the choice of the solver weighs.
constexpr int kUsualSteps = 20;
// Labels are decided at u = .5: more digits of u change none.
constexpr double kTolerance = 1e-5;

double squaredDiagonal(const Sites& sites) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& x : sites.positions) box.extend(x);
  return box.isEmpty() ? 0 : static_cast<double>(box.diagonal().squaredNorm());
}

}  // namespace

SegmentationRun::SegmentationRun(PointSet snapshot, const Parameters& parameters)
    : snapshot_(std::move(snapshot)), parameters_(parameters), options_(readSegmentationOptions(parameters)) {
  if (!options_.hasAutomaticSeeds()) givenSeeds_ = readSeeds(snapshot_, options_.seeds);
}

void SegmentationRun::prepare(Progress& progress) {
  PartialProgress building(progress, 0, 0.5);
  auto terrain = std::make_unique<Terrain>(buildTerrain(snapshot_, options_, building));
  const Discretization& d = terrain->discretization;
  const double area = std::accumulate(d.mass.begin(), d.mass.end(), 0.0);
  spacing_ = std::sqrt(area / std::max<double>(d.size(), 1));
  timeStep_ = options_.timeStep * squaredDiagonal(d.sites);
  terrain_ = std::move(terrain);
  growths_.clear();
  growths_.resize(terrain_->pieces.size());
  labeling_ = {std::vector<std::int32_t>(d.size(), 0), std::vector<float>(d.size(), 0.f)};
  if (!options_.hasAutomaticSeeds()) return plantGivenSeeds(progress);

  std::vector<Index> creases;
  for (Index site = 0; site < d.size(); ++site) {
    if (terrain_->atCrease[site]) creases.push_back(site);
  }
  distance_.assign(d.size(), kUnreached);
  spreadDistance(terrain_->graph, creases, distance_);
  if (!plantNextSeed(progress)) finished_ = true;
}

void SegmentationRun::plantGivenSeeds(const Progress& progress) {
  const std::vector<std::int32_t> seeds = gatherSeeds(terrain_->discretization.sites, givenSeeds_);
  std::map<Index, std::map<std::int32_t, std::vector<Index>>> sitesOfPieces;
  for (Index site = 0; site < seeds.size(); ++site) {
    if (seeds[site] != 0) sitesOfPieces[terrain_->pieces.pieceOfSite[site]][seeds[site]].push_back(site);
  }
  for (const auto& [piece, sitesOfLabels] : sitesOfPieces) {
    std::vector<Index> held;
    for (const auto& [label, sites] : sitesOfLabels) held.insert(held.end(), sites.begin(), sites.end());
    const GrowthOptions options = {
        .timeStep = timeStep_,
        .solver = {.tolerance = kTolerance,
                   .expectedSolves = kUsualSteps * static_cast<int>(sitesOfLabels.size())}};
    growths_[piece] = std::make_unique<LabelGrowth>(terrain_->pieces, piece, terrain_->stiffness,
                                                    terrain_->discretization.mass, held, options, &progress);
    for (const auto& [label, sites] : sitesOfLabels) growths_[piece]->plant(label, sites, labeling_);
    growing_.push_back(piece);
  }
}

LabelGrowth& SegmentationRun::growthOn(Index piece, const Progress& progress) {
  if (!growths_[piece]) {
    const GrowthOptions options = {.timeStep = timeStep_,
                                   .solver = {.tolerance = kTolerance, .expectedSolves = kUsualSteps}};
    growths_[piece] = std::make_unique<LabelGrowth>(terrain_->pieces, piece, terrain_->stiffness,
                                                    terrain_->discretization.mass, std::span<const Index>{},
                                                    options, &progress);
  }
  return *growths_[piece];
}

std::optional<Index> SegmentationRun::findNextSeed() const {
  std::optional<Index> best;
  float bestValue = -1;
  for (Index site = 0; site < distance_.size(); ++site) {
    if (labeling_.labels[site] != 0) continue;
    const Index piece = terrain_->pieces.pieceOfSite[site];
    const bool isFresh = !growths_[piece] && terrain_->pieces.of(piece).size() >= kSmallestPiece;
    const bool hasRoom = distance_[site] >= kRoomInSpacings * spacing_ && distance_[site] < kUnreached;
    if (!isFresh && !hasRoom) continue;
    const float value = options_.seeding == Seeding::kFlattest ? terrain_->classifier[site] : distance_[site];
    if (value > bestValue) {
      bestValue = value;
      best = site;
    }
  }
  return best;
}

bool SegmentationRun::plantNextSeed(const Progress& progress) {
  const std::optional<Index> seed = findNextSeed();
  if (!seed) return false;
  const Index piece = terrain_->pieces.pieceOfSite[*seed];
  LabelGrowth& growth = growthOn(piece, progress);
  growth.clear();
  std::vector<Index> disc =
      discAround(terrain_->graph, *seed, static_cast<float>(kDiscInDiffusionLengths * std::sqrt(timeStep_)));
  std::erase_if(disc, [&](Index site) { return labeling_.labels[site] != 0; });
  growth.plant(++lastLabel_, disc, labeling_);
  growing_ = {piece};
  stepsOfSeed_ = 0;
  return true;
}

void SegmentationRun::spreadFromTaken() {
  std::vector<Index> taken;
  for (const Index site : growths_[growing_.front()]->sites()) {
    if (labeling_.labels[site] == lastLabel_) taken.push_back(site);
  }
  spreadDistance(terrain_->graph, taken, distance_);
}

Index SegmentationRun::growAll(const Progress& progress) {
  Index taken = 0;
  std::vector<Index> still;
  for (const Index piece : growing_) {
    LabelGrowth& growth = *growths_[piece];
    const Index now = growth.step(options_.threshold, labeling_, &progress);
    taken += now;
    if (now > 0 && now >= kStandstill * growth.taken()) still.push_back(piece);
  }
  ++steps_;
  ++stepsOfSeed_;
  const bool ends = still.empty() || stepsOfSeed_ >= options_.steps;
  if (!ends) {
    growing_ = std::move(still);
  } else if (!options_.hasAutomaticSeeds()) {
    finished_ = true;
  } else {
    spreadFromTaken();
    finished_ = !plantNextSeed(progress);
  }
  return taken;
}

void SegmentationRun::finish() {
  if (options_.fill) fillFromNearest(terrain_->graph, labeling_.labels);
}

StepState SegmentationRun::step(Progress& progress) {
  if (!prepared_) prepare(progress);
  prepared_ = true;
  Index taken = 0;
  if (!finished_) taken = growAll(progress);
  if (finished_) finish();
  complete_ = labeling_;
  const auto count = static_cast<double>(std::max<std::size_t>(labeling_.labels.size(), 1));
  const auto free = static_cast<double>(std::count(labeling_.labels.begin(), labeling_.labels.end(), 0));
  const double fraction = finished_ ? 1 : std::min(0.99, 0.5 + 0.5 * (1 - free / count));
  progress.report(fraction, "labels grow");
  return {.finished = finished_, .fraction = fraction, .curve = taken / count};
}

void SegmentationRun::set(const Parameters& parameters) {
  bool goesOn = prepared_ && !finished_;
  for (const Parameter& parameter : parameters.declared()) {
    const bool isLive = parameter.id == "steps" || parameter.id == "threshold" || parameter.id == "fill";
    if (!isLive && parameters.value(parameter.id) != parameters_.value(parameter.id)) goesOn = false;
  }
  if (!goesOn) {
    *this = SegmentationRun(std::move(snapshot_), parameters);
    return;
  }
  parameters_ = parameters;
  options_ = readSegmentationOptions(parameters);
}

RunResult SegmentationRun::result() const {
  RunResult result{.points = snapshot_};
  if (complete_.labels.empty()) return result;
  const Sites& sites = terrain_->discretization.sites;
  std::vector<std::int32_t> labels = scatterToPoints<std::int32_t>(sites, complete_.labels);
  if (options_.hasAutomaticSeeds()) renumberBySize(labels);
  result.points.set("segment", std::move(labels));
  result.points.set("segment_signal", scatterToPoints<float>(sites, complete_.signal));
  return result;
}

Report SegmentationRun::report() const {
  if (complete_.labels.empty()) return {};
  std::vector<std::int32_t> labels =
      scatterToPoints<std::int32_t>(terrain_->discretization.sites, complete_.labels);
  const auto free = std::count(labels.begin(), labels.end(), 0);
  const auto count = static_cast<double>(labels.size());
  Report report;
  report.values = {{"segments", static_cast<std::int64_t>(renumberBySize(labels))},
                   {"labelled", 1 - static_cast<double>(free) / count},
                   {"diffusion_steps", static_cast<std::int64_t>(steps_)},
                   {"k", static_cast<std::int64_t>(terrain_->k)},
                   {"noise", terrain_->noise}};
  if (free == std::ssize(labels))
    report.warnings.push_back("no point was labelled: nowhere is room for a seed");
  return report;
}

}  // namespace stipple
