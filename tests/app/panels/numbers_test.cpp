#include "app/panels/numbers.h"

#include <gtest/gtest.h>

#include <limits>

namespace stipple {
namespace {

TEST(ShortNumber, HasAFewDigitsAndNoZerosBehind) {
  EXPECT_EQ(shortNumber(0), "0");
  EXPECT_EQ(shortNumber(-0.0), "0");
  EXPECT_EQ(shortNumber(1), "1");
  EXPECT_EQ(shortNumber(-3), "\u22123");
  EXPECT_EQ(shortNumber(0.0125), "0.0125");
  EXPECT_EQ(shortNumber(3.14159), "3.14");
  EXPECT_EQ(shortNumber(3.14159, 5), "3.1416");
  EXPECT_EQ(shortNumber(9.996), "10");
  EXPECT_EQ(shortNumber(1234), "1234");
  EXPECT_EQ(shortNumber(1200), "1200");
}

TEST(ShortNumber, WritesPowersOfTenOfWhatIsVeryLargeOrSmall) {
  EXPECT_EQ(shortNumber(1.5e-7), "1.5 \u00d7 10\u207b\u2077");
  EXPECT_EQ(shortNumber(-2e12), "\u22122 \u00d7 10\u00b9\u00b2");
  EXPECT_EQ(shortNumber(1e-5), "10\u207b\u2075");
}

TEST(ShortNumber, NamesWhatIsNoNumber) {
  EXPECT_EQ(shortNumber(std::numeric_limits<double>::quiet_NaN()), "not a number");
  EXPECT_EQ(shortNumber(std::numeric_limits<double>::infinity()), "\u221e");
  EXPECT_EQ(shortNumber(-std::numeric_limits<double>::infinity()), "\u2212\u221e");
}

TEST(Counts, AreGroupedOrRounded) {
  EXPECT_EQ(groupedCount(0), "0");
  EXPECT_EQ(groupedCount(999), "999");
  EXPECT_EQ(groupedCount(1000), "1,000");
  EXPECT_EQ(groupedCount(-134345), "-134,345");
  EXPECT_EQ(groupedCount(1234567), "1,234,567");
  EXPECT_EQ(roundedCount(950), "950");
  EXPECT_EQ(roundedCount(9999), "9,999");
  EXPECT_EQ(roundedCount(12'345), "12.3 k");
  EXPECT_EQ(roundedCount(212'400), "212 k");
  EXPECT_EQ(roundedCount(999'600), "1.0 M");
  EXPECT_EQ(roundedCount(10'000'000), "10.0 M");
}

TEST(Duration, IsSpoken) {
  EXPECT_EQ(spokenDuration(0.2), "less than a second");
  EXPECT_EQ(spokenDuration(3.2), "3 s");
  EXPECT_EQ(spokenDuration(59.7), "1 min");
  EXPECT_EQ(spokenDuration(125), "2 min");
  EXPECT_EQ(spokenDuration(3900), "1 h 5 min");
}

}  // namespace
}  // namespace stipple
