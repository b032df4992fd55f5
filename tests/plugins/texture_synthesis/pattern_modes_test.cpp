#include "plugins/texture_synthesis/pattern_modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace stipple {
namespace {

// Murray, Mathematical Biology II, 2.3: the squared wave number at which the determinant is least,
// q = (Db fa + Da gb) / (2 Da Db), with fa = -s b, gb = s (a - 1) at a = b = 4.
TEST(PatternModes, TurksSpotsAreMarginalAtTheWaveOfTheLeastDeterminant) {
  const double s = 0.2 / 16, da = 0.125, db = 0.03125;
  const double q = (-4 * s * db + 3 * s * da) / (2 * da * db);
  const PatternModes modes = findModes(makePatternSystem(Pattern::kTurkSpots), 2);
  EXPECT_NEAR(modes.wavelength, 2 * std::numbers::pi / std::sqrt(q), 0.1);
  EXPECT_NEAR(modes.growth, 0, 1e-5);
}

// The fastest wave of the differential equation: the root of the dispersion relation, for a short time step.
TEST(PatternModes, SpotsGrowAsTheDispersionRelationSays) {
  const double s = 0.2 / 16, da = 0.15625, db = 0.03125;
  double best = -1, wavelength = 0;
  for (double w = 5; w < 20; w += 0.001) {
    const double q = std::pow(2 * std::numbers::pi / w, 2);
    const double trace = -s - (da + db) * q;
    const double determinant = (-4 * s - da * q) * (3 * s - db * q) + 16 * s * s;
    const double growth = 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4 * determinant)));
    if (growth <= best) continue;
    best = growth;
    wavelength = w;
  }
  const PatternModes modes = findModes(makePatternSystem(Pattern::kSpots), 0.01);
  EXPECT_NEAR(modes.wavelength, wavelength, 0.05);
  EXPECT_NEAR(modes.growth, best, 0.01 * best);
}

TEST(PatternModes, StripesHaveANeutralHomogeneousMode) {
  const PatternSystem stripes = makePatternSystem(Pattern::kStripes);
  for (const double dt : {0.5, 1.0, 2.0, 5.0}) {
    const PatternModes modes = findModes(stripes, dt);
    EXPECT_LE(modes.homogeneousFactor, 1 + 1e-7) << dt;
    EXPECT_GT(modes.growth, 0.01) << dt;
  }
  // The eigenvalues of the differential equation are 0 and +-.04i.
  EXPECT_NEAR(findModes(stripes, 0.01).homogeneousFactor, 1, 1e-6);
}

// A complex pair leaves the unit circle at dt = -trace / determinant = s / (4 s^2).
TEST(PatternModes, LongStepsAreRefusedFromWhereTheyAreUnstable) {
  const PatternSystem spots = makePatternSystem(Pattern::kSpots);
  EXPECT_NO_THROW(requirePattern(Pattern::kSpots, spots, 19.9));
  EXPECT_THROW(requirePattern(Pattern::kSpots, spots, 20.1), InvalidInput);
}

TEST(PatternModes, AReactionWithoutAGrowingWaveIsRefused) {
  PatternSystem spots = makePatternSystem(Pattern::kSpots);
  spots.reaction = TuringReaction{3};
  EXPECT_THROW(requirePattern(Pattern::kSpots, spots, 2), InvalidInput);
}

TEST(PatternModes, EveryPatternFormsAtItsOwnTimeStep) {
  for (int pattern = 0; pattern < 6; ++pattern) {
    const PatternSystem system = makePatternSystem(static_cast<Pattern>(pattern));
    EXPECT_NO_THROW(requirePattern(static_cast<Pattern>(pattern), system, system.timeStep)) << pattern;
  }
}

}  // namespace
}  // namespace stipple
