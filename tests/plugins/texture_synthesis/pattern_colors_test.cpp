#include "plugins/texture_synthesis/pattern_colors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace stipple {
namespace {

TEST(PatternColors, SharesRiseFromLowToHigh) {
  std::vector<float> values(101);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  const std::vector<float> high = figureShares(values, true), low = figureShares(values, false);
  EXPECT_EQ(high.front(), 0);
  EXPECT_EQ(high.back(), 1);
  EXPECT_NEAR(high[50], 0.5, 1e-6);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(high[i] + low[i], 1, 1e-6);
}

TEST(PatternColors, NoPatternIsAllGround) {
  EXPECT_THAT(figureShares(std::vector<float>(10, 4.f), false), testing::Each(0.f));
  EXPECT_TRUE(figureShares({}, true).empty());
}

TEST(PatternColors, AFewSeedsAreSeen) {
  std::vector<float> values(1000, 0.75f);
  values[500] = 1;
  const std::vector<float> shares = figureShares(values, true);
  EXPECT_EQ(shares[500], 1);
  EXPECT_EQ(std::count(shares.begin(), shares.end(), 0.f), 999);
}

TEST(PatternColors, EndsAreExactAndTheMiddleIsMixedInLinearLight) {
  const std::vector<float> shares = {0, 0.5f, 1};
  const std::vector<Rgba8> colors = blendColors(shares, {0, 10, 20}, {255, 10, 40});
  EXPECT_EQ(colors[0], (Rgba8{0, 10, 20}));
  EXPECT_EQ(colors[2], (Rgba8{255, 10, 40}));
  // Half the light is 188 in sRGB.
  EXPECT_NEAR(colors[1].r, 188, 1);
  EXPECT_EQ(colors[1].g, 10);
}

}  // namespace
}  // namespace stipple
