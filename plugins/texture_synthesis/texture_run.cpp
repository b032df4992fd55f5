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
constexpr std::size_t kBlock = 4096;

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
    isGuided_ = true;
  }
  if (!isScaled_) scale();
  if (species_.empty()) begin(progress);
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
  right_.resize(sites.size());
  next_.resize(sites.size());
  species_ = std::move(species);
  if (options_.resume) readSpecies();
}

void TextureRun::readSpecies() {
  for (std::size_t s = 0; s < species_.size(); ++s) {
    species_[s] = gatherToSites(surface_->discretization.sites, snapshot_.values<float>(kSpeciesNames[s]));
    for (std::size_t site = 0; site < species_[s].size(); ++site) {
      float& value = species_[s][site];
      if (!std::isfinite(value)) value = system_.steady[s];
    }
  }
}

// Right-hand sides of a pair at all sites, and the state before as first guess.
void TextureRun::reactAll(std::size_t number) {
  const auto dt = static_cast<float>(timeStep());
  std::visit(
      [&](const auto& reaction) {
        constexpr auto kSpecies = static_cast<std::size_t>(std::decay_t<decltype(reaction)>::kSpecies);
        const DiffusingPair pair = reaction.pairs()[number];
        const auto first = static_cast<std::size_t>(pair.species[0]), second = first + 1;
        parallelFor(beta_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            std::array<float, kSpecies> u;
            for (std::size_t s = 0; s < kSpecies; ++s) u[s] = species_[s][i];
            const auto right = reaction.react(number, dt, beta_[i], u.data());
            right_[i] = Pair{right[0], right[1]};
            next_[i] = Pair{u[first], u[second]};
            if constexpr (kSpecies == 5) species_[2][i] = u[2];
          }
        });
      },
      system_.reaction);
}

// Sum of the squared changes of the species shown, where it is one of the pair.
double TextureRun::advancePair(const DiffusingPair& pair, std::size_t number) {
  reactAll(number);
  const double dt = timeStep();
  PairTerms terms;
  for (std::size_t lane = 0; lane < 2; ++lane) {
    terms.mass[lane] = 1 + dt * pair.decay[lane];
    terms.stiffness[lane] = dt * pair.diffusion[lane] * cell_ * cell_;
  }
  iterations_ += surface_->diffusion->solve(terms, right_, next_);
  const auto first = static_cast<std::size_t>(pair.species[0]), second = first + 1;
  const auto shown = static_cast<std::size_t>(system_.shown);
  return parallelSum(beta_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      // Concentrations; only an unfinished solve or a strong reaction reaches below 0.
      const Pair value{std::max(next_[i][0], 0.f), std::max(next_[i][1], 0.f)};
      if (shown == first || shown == second) {
        const double change = static_cast<double>(value[shown == first ? 0 : 1] - species_[shown][i]);
        sum += change * change;
      }
      species_[first][i] = value[0];
      species_[second][i] = value[1];
    }
    return sum;
  });
}

double TextureRun::advance() {
  double squaredChange = 0;
  const std::vector<DiffusingPair> pairs =
      std::visit([](const auto& reaction) { return reaction.pairs(); }, system_.reaction);
  for (std::size_t number = 0; number < pairs.size(); ++number)
    squaredChange += advancePair(pairs[number], number);
  const double change = std::sqrt(squaredChange / static_cast<double>(beta_.size()));
  if (!std::isfinite(change)) throw SolverError("the concentrations grew beyond all bounds");
  return change;
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
  for (std::size_t s = 0; s < species_.size(); ++s) {
    result.points.set(kSpeciesNames[s], scatterToPoints<float>(sites, species_[s]));
  }
  if (options_.color) {
    const std::vector<float> shares =
        figureShares(species_[static_cast<std::size_t>(system_.shown)], system_.figureIsHigh);
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
                   {"solver_iterations", static_cast<double>(iterations_) / steps_}};
  if (system_.patchSize == 0) report.values.emplace_back("growth", findModes(system_, timeStep()).growth);
  if (pointsOfWave < kFairPointsOfWave) {
    report.warnings.push_back(
        fmt::format("a pattern of size {:.4g} is rough on these points; from {:.4g} it is even", size_,
                    size_ * kFairPointsOfWave / pointsOfWave));
  }
  return report;
}

}  // namespace stipple
