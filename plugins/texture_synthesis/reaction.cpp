#include "plugins/texture_synthesis/reaction.h"

namespace stipple {

namespace {

// Turk's own ratio of 4 is exactly marginal: growth comes from the irregularities alone and takes three times
// as long.
PatternSystem makeSpots(double ratio, int steps, double sizeOfWave) {
  return {.reaction = TuringReaction{ratio},
          .steady = {4, 4},
          .beta = 12,
          .variation = 0.1,
          .timeStep = 2,
          .steps = steps,
          .sizeOfWave = sizeOfWave,
          .shown = 1,
          .figureIsHigh = false};
}

PatternSystem makeStripes() {
  // k2 / (2 k1), and c from a' = 0.
  constexpr float a = 0.75f;
  return {.reaction = MeinhardtReaction{},
          .steady = {a, a, 0.02f * a * a * a / 0.06f, a, a},
          .variation = 0.01,
          .timeStep = 2,
          .steps = 500,
          .shown = 0};
}

}  // namespace

PatternSystem makePatternSystem(Pattern pattern) {
  switch (pattern) {
    case Pattern::kSpots:
      return makeSpots(5, 1000, 1.13);
    case Pattern::kTurkSpots:
      return makeSpots(4, 1700, 1.13);
    case Pattern::kStripes:
      return makeStripes();
    case Pattern::kZebra: {
      PatternSystem system = makeStripes();
      system.beginning = Beginning::kSeeds;
      system.variation = 0;
      system.steps = 650;
      return system;
    }
    case Pattern::kGrayScott:
      return {.reaction = GrayScottReaction{},
              .beginning = Beginning::kPatches,
              .steady = {1, 0},
              .timeStep = 2,
              // b reaches .45, and explicit a b^2 must leave some of a.
              .longestStep = 4,
              .steps = 4000,
              .patchSize = 9.05,
              .shown = 1};
    case Pattern::kGiererMeinhardt:
      // p2 / p1 and .01 a^2 / p2.
      return {.reaction = GiererMeinhardtReaction{},
              .steady = {4.f / 3, 4.f / 9},
              .variation = 0.1,
              .timeStep = 5,
              .steps = 1000,
              .sizeOfWave = 0.96,
              .shown = 0};
  }
  return {};
}

const char* nameOf(Pattern pattern) {
  constexpr std::array kNames = {"spots", "turk_spots", "stripes", "zebra", "gray_scott", "gierer_meinhardt"};
  return kNames[static_cast<std::size_t>(pattern)];
}

}  // namespace stipple
