#include "app/panels/curve_scale.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace stipple {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(CurveScale, IsLogarithmicForResidualsOnly) {
  EXPECT_TRUE(scaleFor(std::vector<double>{1, 1e-3, 1e-6}).isLogarithmic);
  EXPECT_FALSE(scaleFor(std::vector<double>{1, 2, 40}).isLogarithmic);
  EXPECT_FALSE(scaleFor(std::vector<double>{1, 1e-6, 0}).isLogarithmic) << "zero has no logarithm";
  EXPECT_FALSE(scaleFor(std::vector<double>{-1, 1000}).isLogarithmic);
}

TEST(CurveScale, HoldsEveryValue) {
  for (const std::vector<double>& values :
       {std::vector<double>{1, 1e-6}, {3, 4, 5}, {-2, -7}, {5}, {0, 0}, {-1e-9, 1e9}}) {
    const CurveScale scale = scaleFor(values);
    ASSERT_LT(scale.low, scale.high);
    for (const double value : values) {
      EXPECT_LE(scale.low, value);
      EXPECT_GE(scale.high, value);
    }
    EXPECT_NEAR(scale.heightOf(scale.low), 0, 1e-12);
    EXPECT_NEAR(scale.heightOf(scale.high), 1, 1e-12);
  }
}

TEST(CurveScale, HalfOfTheHeightIsTheMeanOrTheGeometricMean) {
  EXPECT_NEAR((CurveScale{.low = 2, .high = 6}.heightOf(4)), 0.5, 1e-12);
  EXPECT_NEAR((CurveScale{.low = 1e-4, .high = 1, .isLogarithmic = true}.heightOf(1e-2)), 0.5, 1e-12);
}

TEST(CurveScale, PassesOverWhatIsNoNumber) {
  const CurveScale scale = scaleFor(std::vector<double>{kNan, 3, INFINITY, 4});
  EXPECT_LT(scale.low, 3);
  EXPECT_LT(scale.high, 5);
  EXPECT_EQ(scale.heightOf(kNan), 0);
  EXPECT_EQ(scale.heightOf(INFINITY), 1);
  const CurveScale empty = scaleFor({});
  EXPECT_EQ(empty.low, 0);
  EXPECT_EQ(empty.high, 1);
}

TEST(CurveScale, ShowsZeroWhereItIsNear) {
  EXPECT_EQ(scaleFor(std::vector<double>{1, 10}).low, 0);
  EXPECT_GT(scaleFor(std::vector<double>{9, 10}).low, 8);
}

TEST(CurveTicks, ArePowersOfTenOnALogarithmicScale) {
  EXPECT_THAT(ticksOf({.low = 2e-3, .high = 3, .isLogarithmic = true}, 4), ElementsAre(0.01, 0.1, 1));
  EXPECT_LE(ticksOf({.low = 1e-30, .high = 1, .isLogarithmic = true}, 4).size(), 5u);
  EXPECT_THAT(ticksOf({.low = 0, .high = 10}, 3), ElementsAre(0, 5, 10));
}

}  // namespace
}  // namespace stipple
