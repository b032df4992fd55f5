#include "plugins/texture_synthesis/pattern_modes.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "core/error.h"

namespace stipple {

namespace {

// One step of a wave of squared wave number kappa (1 / cells^2): what the solves do to one of its values.
std::vector<double> stepWave(const PatternSystem& system, double dt, double kappa, std::vector<double> u) {
  std::visit(
      [&](const auto& reaction) {
        const std::vector<DiffusingPair> pairs = reaction.pairs();
        for (std::size_t p = 0; p < pairs.size(); ++p) {
          const auto right = reaction.react(p, dt, system.beta, u.data());
          for (std::size_t lane = 0; lane < 2; ++lane) {
            const double denominator = 1 + dt * (pairs[p].decay[lane] + pairs[p].diffusion[lane] * kappa);
            u[static_cast<std::size_t>(pairs[p].species[lane])] = right[lane] / denominator;
          }
        }
      },
      system.reaction);
  return u;
}

// Spectral radius of the derivative of that step at the homogeneous state.
double growthFactor(const PatternSystem& system, double dt, double kappa) {
  const auto n = static_cast<Eigen::Index>(system.species());
  const std::vector<double> steady(system.steady.begin(), system.steady.end());
  // Central differences: exact to rounding for these polynomials and quotients at this width.
  constexpr double kWidth = 1e-5;
  Eigen::MatrixXd derivative(n, n);
  for (Eigen::Index s = 0; s < n; ++s) {
    std::vector<double> more = steady, less = steady;
    more[static_cast<std::size_t>(s)] += kWidth;
    less[static_cast<std::size_t>(s)] -= kWidth;
    more = stepWave(system, dt, kappa, more);
    less = stepWave(system, dt, kappa, less);
    for (Eigen::Index t = 0; t < n; ++t) {
      derivative(t, s) =
          (more[static_cast<std::size_t>(t)] - less[static_cast<std::size_t>(t)]) / (2 * kWidth);
    }
  }
  return derivative.eigenvalues().cwiseAbs().maxCoeff();
}

// What rounding makes of the neutral homogeneous mode of stripes, for one step.
constexpr double kNeutral = 1e-7;
// A wave may die as slowly as this, for one step: Turk's spots are marginal, and waves are sampled.
constexpr double kMarginal = -1e-4;

bool isStable(const PatternSystem& system, double dt) {
  return dt <= system.longestStep && growthFactor(system, dt, 0) <= 1 + kNeutral;
}

double largestStableStep(const PatternSystem& system, double unstable) {
  double low = 0, high = unstable;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    (isStable(system, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

PatternModes findModes(const PatternSystem& system, double timeStep) {
  PatternModes modes{.homogeneousFactor = growthFactor(system, timeStep, 0)};
  // Wavelengths from 2 to 100 cells in steps of half a percent.
  double best = 0;
  for (double wavelength = 2; wavelength < 100; wavelength *= 1.005) {
    const double waveNumber = 2 * std::numbers::pi / wavelength;
    const double factor = growthFactor(system, timeStep, waveNumber * waveNumber);
    if (factor <= best) continue;
    best = factor;
    modes.wavelength = wavelength;
  }
  modes.growth = std::log(best) / timeStep;
  return modes;
}

void requirePattern(Pattern pattern, const PatternSystem& system, double timeStep) {
  if (!isStable(system, timeStep)) {
    throw InvalidInput(fmt::format("{} would be unstable with a time step of {:.3g}: at most {:.3g}",
                                   nameOf(pattern), timeStep, largestStableStep(system, timeStep)));
  }
  if (system.beginning == Beginning::kNoise && findModes(system, timeStep).growth * timeStep < kMarginal) {
    throw InvalidInput(
        fmt::format("{} cannot form with a time step of {:.3g}: no wave grows", nameOf(pattern), timeStep));
  }
}

}  // namespace stipple
