#include "plugins/texture_synthesis/texture_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plugins/texture_synthesis/pattern_colors.h"
#include "plugins/texture_synthesis/pattern_modes.h"
#include "plugins/texture_synthesis/pattern_seeds.h"

namespace stipple {

namespace {

constexpr std::array kSpeciesNames = {"species_a", "species_b", "species_c", "species_d", "species_e"};

// A wave on fewer points than this is no wave; below the second number it is rough.
constexpr double kLeastPointsOfWave = 4, kFairPointsOfWave = 8;
// The default size: a wave of so many spacings, at least this share of the diagonal.
constexpr double kUsualPointsOfWave = 12, kUsualShare = 1.0 / 25;
// And never so large that but a handful fit on a coarse model.
constexpr double kLargestShare = 0.3;
// Of a patch of Gray and Scott's second species: what they and Pearson (1993) start from.
constexpr float kPatchA = 0.5f, kPatchB = 0.25f;

// Size over the cell and over the wavelength, which the number of points must hold.
struct Proportions {
  double cells, waves;
};

Proportions proportionsOf(const PatternSystem& system, double timeStep) {
  if (system.patchSize > 0) return {system.patchSize, 1};
  return {findModes(system, timeStep).wavelength * system.sizeOfWave, system.sizeOfWave};
}

double usualSize(const PatternSurface& surface, double waves, double least) {
  const double share = waves * std::max(kUsualPointsOfWave * surface.spacing, kUsualShare * surface.diagonal);
  return std::max(least, std::min(share, kLargestShare * std::sqrt(surface.area)));
}

}  // namespace

TextureRun::TextureRun(PointSet snapshot, const Parameters& parameters)
    : snapshot_(std::move(snapshot)),
      parameters_(parameters),
      options_(readTextureOptions(parameters)),
      system_(makePatternSystem(options_.pattern)) {
  requirePattern(options_.pattern, system_, timeStep());
  checkGuides(snapshot_, {options_.sizeBy, options_.directionBy});
  if (options_.resume) {
    for (int s = 0; s < system_.species(); ++s) {
      const char* name = kSpeciesNames[static_cast<std::size_t>(s)];
      if (const Attribute* found = snapshot_.find(name); !found || found->type() != AttributeType::kFloat) {
        throw InvalidInput(fmt::format("to go on, {} needs the attribute \"{}\" (float) of an earlier run",
                                       nameOf(options_.pattern), name));
      }
    }
  }
}

void TextureRun::prepare(Progress& progress) {
  if (!surface_) {
    PartialProgress building(progress, 0, 1.0 / stepsWanted());
    surface_ = buildPatternSurface(snapshot_, options_.discretization, building);
  }
  if (!isGuided_) {
    guideDiffusion(*surface_, snapshot_, {options_.sizeBy, options_.directionBy}, &progress);
    plans_.clear();
    isGuided_ = true;
  }
  if (!isScaled_) scale();
  if (fields_.empty()) begin(progress);
}

// Wanted size to the unit of length of the published systems.
void TextureRun::scale() {
  const Proportions per = proportionsOf(system_, timeStep());
  const double least = per.waves * kLeastPointsOfWave * surface_->spacing / surface_->finest;
  size_ = options_.size > 0 ? options_.size : usualSize(*surface_, per.waves, least);
  if (size_ < least) {
    throw InvalidInput(
        fmt::format("a pattern of size {:.4g} is too fine for these points: at least {:.4g}", size_, least));
  }
  if (2 * surface_->area < std::sqrt(3) * size_ * size_) {
    throw InvalidInput(
        fmt::format("a pattern of size {:.4g} cannot form on a surface of area {:.4g}: at most {:.4g}", size_,
                    surface_->area, std::sqrt(2 * surface_->area / std::sqrt(3))));
  }
  cell_ = size_ / per.cells;
  pairs_ = std::visit([](const auto& reaction) { return reaction.pairs(); }, system_.reaction);
  planSolves();
  isScaled_ = true;
}

void TextureRun::begin(const Progress& progress) {
  const Sites& sites = surface_->discretization.sites;
  beta_ = irregularities(sites.size(), options_.seed);
  for (float& value : beta_) {
    value = static_cast<float>(system_.beta) + static_cast<float>(system_.variation) * value;
  }
  std::vector<std::vector<float>> species;
  for (const float value : system_.steady) species.emplace_back(sites.size(), value);
  if (!options_.resume && system_.beginning == Beginning::kSeeds) {
    const std::vector<Index> seeds = options_.seeds.empty()
                                         ? seedsAtEdges(sites, options_.seedFraction, &progress)
                                         : seedsFromAttribute(snapshot_, sites, options_.seeds);
    for (const Index site : seeds) species[0][site] = 1;
  }
  if (!options_.resume && system_.beginning == Beginning::kPatches) {
    for (const Index site : scatteredDiscs(*surface_, 0.5 * size_, options_.seed)) {
      species[0][site] = kPatchA;
      species[1][site] = kPatchB;
    }
  }
  if (options_.resume) readSpecies(species);
  pack(species);
}

void TextureRun::readSpecies(std::vector<std::vector<float>>& species) const {
  for (std::size_t s = 0; s < species.size(); ++s) {
    species[s] = gatherToSites(surface_->discretization.sites, snapshot_.values<float>(kSpeciesNames[s]));
    for (float& value : species[s]) {
      if (!std::isfinite(value)) value = system_.steady[s];
    }
  }
}

void TextureRun::pack(const std::vector<std::vector<float>>& species) {
  const std::size_t room = 2 * surface_->diffusion->paddedSites();
  right_.assign(room, 0);
  next_.assign(room, 0);
  std::vector<std::vector<float>> fields;
  if (species.size() == 5) still_ = species[2];
  for (const DiffusingPair& pair : pairs_) {
    std::vector<float>& field = fields.emplace_back(room, 0.f);
    for (std::size_t i = 0; i < 2 * beta_.size(); ++i) {
      field[i] = species[static_cast<std::size_t>(pair.species[i % 2])][i / 2];
    }
  }
  fields_ = std::move(fields);
}

std::vector<float> TextureRun::speciesAt(std::size_t species) const {
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    for (std::size_t lane = 0; lane < 2; ++lane) {
      if (static_cast<std::size_t>(pairs_[p].species[lane]) != species) continue;
      std::vector<float> values(beta_.size());
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = fields_[p][2 * i + lane];
      return values;
    }
  }
  return still_;
}

void TextureRun::planSolves() {
  const double dt = timeStep();
  plans_.resize(pairs_.size());
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    PairTerms terms;
    for (std::size_t lane = 0; lane < 2; ++lane) {
      terms.mass[lane] = 1 + dt * pairs_[p].decay[lane];
      terms.stiffness[lane] = dt * pairs_[p].diffusion[lane] * cell_ * cell_;
    }
    if (plans_[p].inverse.empty() || plans_[p].terms != terms) plans_[p] = surface_->diffusion->plan(terms);
  }
}

// Right-hand sides of a pair.
void TextureRun::react(std::size_t number, std::size_t begin, std::size_t end) {
  const auto dt = static_cast<float>(timeStep());
  const float *first = fields_.front().data(), *second = fields_.back().data(), *beta = beta_.data();
  float *still = still_.data(), *right = right_.data();
  std::visit(
      [&](const auto& reaction) {
        for (std::size_t i = begin; i < end; ++i) {
          std::array<float, 2> rates;
          if constexpr (std::decay_t<decltype(reaction)>::kSpecies == 5) {
            float u[] = {first[2 * i], first[2 * i + 1], still[i], second[2 * i], second[2 * i + 1]};
            rates = reaction.react(number, dt, beta[i], u);
            still[i] = u[2];
          } else {
            float u[] = {first[2 * i], first[2 * i + 1]};
            rates = reaction.react(number, dt, beta[i], u);
          }
          right[2 * i] = rates[0];
          right[2 * i + 1] = rates[1];
        }
      },
      system_.reaction);
}

// Root mean square of the changes of the species shown.
double TextureRun::advance() {
  double squaredChange = 0;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const PairDiffusion::Outcome outcome =
        surface_->diffusion->solve(plans_[p], {.right = right_, .before = fields_[p], .after = next_},
                                   [&](std::size_t begin, std::size_t end) { react(p, begin, end); });
    fields_[p].swap(next_);
    sweeps_ += outcome.sweeps;
    for (std::size_t lane = 0; lane < 2; ++lane) {
      if (pairs_[p].species[lane] == system_.shown) squaredChange += outcome.squaredChange[lane];
    }
  }
  return std::sqrt(squaredChange / static_cast<double>(beta_.size()));
}

StepState TextureRun::step(Progress& progress) {
  progress.throwIfCancelled();
  prepare(progress);
  std::optional<double> change;
  if (steps_ < stepsWanted()) {
    change = advance();
    ++steps_;
  }
  const bool finished = steps_ >= stepsWanted();
  const double fraction = finished ? 1 : static_cast<double>(steps_) / stepsWanted();
  return {.finished = finished, .fraction = fraction, .curve = change};
}

bool TextureRun::goesOnWith(const Parameters& parameters) const {
  constexpr std::array kLive = {"size",    "steps", "time_step",    "size_by",     "direction_by",
                                "pattern", "color", "color_ground", "color_figure"};
  for (const Parameter& parameter : parameters.declared()) {
    const bool isLive = std::find(kLive.begin(), kLive.end(), parameter.id) != kLive.end();
    if (!isLive && parameters.value(parameter.id) != parameters_.value(parameter.id)) return false;
  }
  const PatternSystem other = makePatternSystem(readTextureOptions(parameters).pattern);
  return other.reaction.index() == system_.reaction.index() && other.beginning == system_.beginning;
}

void TextureRun::set(const Parameters& parameters) {
  // A run of its own checks what is given, before anything is touched.
  TextureRun fresh(snapshot_, parameters);
  if (!goesOnWith(parameters)) {
    *this = std::move(fresh);
    return;
  }
  const bool sameGuides =
      fresh.options_.sizeBy == options_.sizeBy && fresh.options_.directionBy == options_.directionBy;
  isGuided_ = isGuided_ && sameGuides;
  isScaled_ = false;
  parameters_ = parameters;
  options_ = std::move(fresh.options_);
  system_ = std::move(fresh.system_);
}

RunResult TextureRun::result() const {
  RunResult result{.points = snapshot_};
  if (steps_ == 0) return result;
  const Sites& sites = surface_->discretization.sites;
  for (std::size_t s = 0; s < system_.steady.size(); ++s) {
    result.points.set(kSpeciesNames[s], scatterToPoints<float>(sites, speciesAt(s)));
  }
  if (options_.color) {
    const std::vector<float> shares =
        figureShares(speciesAt(static_cast<std::size_t>(system_.shown)), system_.figureIsHigh);
    const std::vector<Rgba8> colors = blendColors(shares, options_.ground, options_.figure);
    result.points.set("color", scatterToPoints<Rgba8>(sites, colors));
  }
  return result;
}

Report TextureRun::report() const {
  if (steps_ == 0) return {};
  const Proportions per = proportionsOf(system_, timeStep());
  const double pointsOfWave = size_ / per.waves / surface_->spacing * surface_->finest;
  Report report;
  report.values = {{"size", size_},
                   {"spacing", surface_->spacing},
                   {"points_of_wave", pointsOfWave},
                   {"area", surface_->area},
                   {"time_step", timeStep()},
                   {"solver_iterations", static_cast<double>(sweeps_) / steps_}};
  if (system_.patchSize == 0) report.values.emplace_back("growth", findModes(system_, timeStep()).growth);
  if (pointsOfWave < kFairPointsOfWave) {
    report.warnings.push_back(
        fmt::format("a pattern of size {:.4g} is rough on these points; from {:.4g} it is even", size_,
                    size_ * kFairPointsOfWave / pointsOfWave));
  }
  return report;
}

}  // namespace stipple
