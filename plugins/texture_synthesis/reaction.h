#pragma once

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

namespace stipple {

/// In the order of the choices of the parameter `pattern`.
enum class Pattern { kSpots, kTurkSpots, kStripes, kZebra, kGrayScott, kGiererMeinhardt };

/// Two species that diffuse in one implicit solve: ((1 + dt decay) M + dt diffusion ell^2 L) u' = M r, with
/// the right-hand sides r of a reaction. Diffusion in cells^2 per unit of time.
struct DiffusingPair {
  std::array<int, 2> species;
  std::array<double, 2> diffusion;
  std::array<double, 2> decay;
};

// A reaction: pairs(), one pair after another within a time step, and
// react(pair, dt, beta, u): the right-hand sides of that pair at one point, from all species u there; it may
// also step a species that does not diffuse. All in the units of the published systems.

/// Turing's system with the constants of Turk (1991): a' = s(16 - ab), b' = s(ab - b - beta).
struct TuringReaction {
  static constexpr int kSpecies = 2;
  double ratio;  ///< Da / Db

  std::vector<DiffusingPair> pairs() const { return {{{0, 1}, {0.03125 * ratio, 0.03125}, {0, 0}}}; }

  template <class Number>
  std::array<Number, 2> react(std::size_t, Number dt, Number beta, Number* u) const {
    constexpr auto s = static_cast<Number>(0.2 / 16);
    const Number ab = u[0] * u[1];
    return {u[0] + dt * s * (16 - ab), u[1] + dt * s * (ab - u[1] - beta)};
  }
};

/// Meinhardt's five-species system for stripes as in Turk (1991). Decay is taken implicitly (Patankar): the
/// homogeneous mode is neutral, and an explicit step would amplify it without end.
struct MeinhardtReaction {
  static constexpr int kSpecies = 5;
  static constexpr double kDecayA = 0.04, kDecayC = 0.06, kExchange = 0.04;

  std::vector<DiffusingPair> pairs() const {
    return {{{0, 1}, {0.009, 0.009}, {kDecayA, kDecayA}}, {{3, 4}, {0.2, 0.2}, {kExchange, kExchange}}};
  }

  template <class Number>
  std::array<Number, 2> react(std::size_t pair, Number dt, Number beta, Number* u) const {
    constexpr auto exchange = static_cast<Number>(kExchange);
    if (pair == 1) return {u[3] + dt * exchange * u[0], u[4] + dt * exchange * u[1]};
    constexpr auto rate = static_cast<Number>(0.01);
    const Number gainA = rate * u[0] * u[0] * u[4] * beta, gainB = rate * u[1] * u[1] * u[3];
    // Far below any concentration: only 0 / 0 is kept out.
    constexpr auto least = static_cast<Number>(1e-20);
    u[2] = std::max((u[2] + dt * (gainA + gainB)) / (1 + dt * static_cast<Number>(kDecayC)), least);
    return {u[0] + dt * gainA / u[2], u[1] + dt * gainB / u[2]};
  }
};

/// Gray and Scott: a' = F(1 - a) - a b^2, b' = a b^2 - (F + K) b; linear decay implicit.
struct GrayScottReaction {
  static constexpr int kSpecies = 2;
  static constexpr double kFeed = 0.035, kKill = 0.064;

  std::vector<DiffusingPair> pairs() const { return {{{0, 1}, {0.082, 0.041}, {kFeed, kFeed + kKill}}}; }

  template <class Number>
  std::array<Number, 2> react(std::size_t, Number dt, Number, Number* u) const {
    const Number gain = u[0] * u[1] * u[1];
    return {u[0] + dt * (static_cast<Number>(kFeed) - gain), u[1] + dt * gain};
  }
};

/// Gierer and Meinhardt: a' = s(.01 a^2 beta / b - .03 a), b' = s(.01 a^2 beta - .04 b), s = .2; decay
/// implicit.
struct GiererMeinhardtReaction {
  static constexpr int kSpecies = 2;
  static constexpr double kSpeed = 0.2, kDecayA = 0.03, kDecayB = 0.04;

  std::vector<DiffusingPair> pairs() const {
    return {{{0, 1}, {0.01, 0.2}, {kSpeed * kDecayA, kSpeed * kDecayB}}};
  }

  template <class Number>
  std::array<Number, 2> react(std::size_t, Number dt, Number beta, Number* u) const {
    constexpr auto rate = static_cast<Number>(0.01 * kSpeed), least = static_cast<Number>(1e-20);
    const Number gain = dt * rate * u[0] * u[0] * beta;
    return {u[0] + gain / std::max(u[1], least), u[1] + gain};
  }
};

using Reaction = std::variant<TuringReaction, MeinhardtReaction, GrayScottReaction, GiererMeinhardtReaction>;

/// How a pattern starts.
enum class Beginning { kNoise, kSeeds, kPatches };

/// A reaction with everything else that makes a pattern of it.
struct PatternSystem {
  Reaction reaction;
  Beginning beginning = Beginning::kNoise;
  std::vector<float> steady;  ///< the homogeneous state, one value a species
  double beta = 1;            ///< of the reaction, mean and
  double variation = 0;       ///< half width of its irregularities, frozen at each point
  double timeStep = 1;
  double longestStep = 100;  ///< beyond what the homogeneous state tells
  int steps = 1000;
  /// Wanted size over the wavelength of the fastest mode: what grows in the end is not what grows first, and
  /// size means the distance in a hexagonal packing.
  double sizeOfWave = 1;
  /// Where no mode grows out of the homogeneous state: the size of the final pattern, in cells.
  double patchSize = 0;
  int shown = 0;             ///< the species to look at
  bool figureIsHigh = true;  ///< spots or stripes are where it is high

  int species() const { return static_cast<int>(steady.size()); }
};

PatternSystem makePatternSystem(Pattern pattern);
/// "spots", ... as users write it.
const char* nameOf(Pattern pattern);

}  // namespace stipple
