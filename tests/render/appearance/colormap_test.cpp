#include "render/appearance/colormap.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

#include "render/appearance/label_palette.h"
#include "render/appearance/light.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Rgba8 fromHex(std::uint32_t hex) {
  return {std::uint8_t(hex >> 16), std::uint8_t(hex >> 8), std::uint8_t(hex), 255};
}

int difference(const Rgba8& a, const Rgba8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// CIELAB, D65.
struct Lab {
  double l, a, b;
};
Lab labOf(const Rgba8& color) {
  const double r = linearFromSrgb(color.r / 255.F), g = linearFromSrgb(color.g / 255.F),
               b = linearFromSrgb(color.b / 255.F);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29; };
  const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(Colormap, ViridisAgreesWithItsTableAtEighths) {
  // The nine colors that its authors publish for nine steps.
  const std::uint32_t published[] = {0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21908C,
                                     0x27AD81, 0x5DC863, 0xAADC32, 0xFDE725};
  for (int i = 0; i <= 8; ++i) {
    EXPECT_LE(difference(mapColor(Colormap::kViridis, i / 8.0), fromHex(published[i])), 4) << i;
  }
}

TEST(Colormap, ViridisIsEvenInLightness) {
  const double low = labOf(mapColor(Colormap::kViridis, 0)).l,
               high = labOf(mapColor(Colormap::kViridis, 1)).l;
  for (int i = 0; i < 100; ++i) {
    const double here = labOf(mapColor(Colormap::kViridis, i / 100.0)).l;
    const double next = labOf(mapColor(Colormap::kViridis, (i + 1) / 100.0)).l;
    EXPECT_GT(next, here) << i;
    EXPECT_NEAR(here, low + (high - low) * i / 100, 4) << i;
  }
}

TEST(Colormap, TurboAgreesWithItsTable) {
  // First, middle and last row of the table that the map was published with. The polynomial, published beside
  // it, leaves it by up to 0.13, most at the dark ends.
  EXPECT_LE(difference(mapColor(Colormap::kTurbo, 0), {48, 18, 59, 255}), 33);
  EXPECT_LE(difference(mapColor(Colormap::kTurbo, 128 / 255.0), {164, 252, 60, 255}), 20);
  EXPECT_LE(difference(mapColor(Colormap::kTurbo, 1), {122, 4, 3, 255}), 33);
}

TEST(Colormap, BlueToRedAgreesWithItsTable) {
  // Moreland (2009): ends and middle.
  EXPECT_LE(difference(mapColor(Colormap::kBlueToRed, 0), {59, 76, 192, 255}), 1);
  EXPECT_LE(difference(mapColor(Colormap::kBlueToRed, 0.5), {221, 221, 221, 255}), 1);
  EXPECT_LE(difference(mapColor(Colormap::kBlueToRed, 1), {180, 4, 38, 255}), 1);
  for (int i = 0; i < 50; ++i) {
    EXPECT_LT(labOf(mapColor(Colormap::kBlueToRed, i / 100.0)).l,
              labOf(mapColor(Colormap::kBlueToRed, (i + 1) / 100.0)).l);
    EXPECT_GT(labOf(mapColor(Colormap::kBlueToRed, 0.5 + i / 100.0)).l,
              labOf(mapColor(Colormap::kBlueToRed, 0.5 + (i + 1) / 100.0)).l);
  }
}

TEST(Colormap, GrayIsTheNumberItself) {
  EXPECT_EQ(mapColor(Colormap::kGray, 0), (Rgba8{0, 0, 0, 255}));
  EXPECT_EQ(mapColor(Colormap::kGray, 0.2), (Rgba8{51, 51, 51, 255}));
  EXPECT_EQ(mapColor(Colormap::kGray, 1), (Rgba8{255, 255, 255, 255}));
}

TEST(Colormap, EveryMapClampsShowsNaNGrayAndNeverJumps) {
  ASSERT_THAT(colormapNames(), SizeIs(4));
  for (int m = 0; m < 4; ++m) {
    const auto map = static_cast<Colormap>(m);
    EXPECT_EQ(mapColor(map, -1), mapColor(map, 0));
    EXPECT_EQ(mapColor(map, std::numeric_limits<double>::infinity()), mapColor(map, 1));
    EXPECT_EQ(mapColor(map, kNaN), (Rgba8{128, 128, 128, 255}));
    for (int i = 0; i < 1000; ++i) {
      EXPECT_LE(difference(mapColor(map, i / 1000.0), mapColor(map, (i + 1) / 1000.0)), 4);
    }
  }
}

TEST(LabelColor, ZeroIsGrayAndOthersAreTold) {
  EXPECT_EQ(labelColor(0), (Rgba8{128, 128, 128, 255}));
  const auto distance = [](const Rgba8& a, const Rgba8& b) {
    const Lab p = labOf(a), q = labOf(b);
    return std::hypot(p.l - q.l, p.a - q.a, p.b - q.b);
  };
  // In CIELAB 2.3 is just noticeable.
  const auto least = [&](int count) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < i; ++j) nearest = std::min(nearest, distance(labelColor(i), labelColor(j)));
    }
    return nearest;
  };
  EXPECT_GT(least(8), 30);
  EXPECT_GT(least(24), 15);
  EXPECT_GT(least(256), 3);
}

TEST(LabelColor, RepeatsAfterTheWholePaletteOnly) {
  const auto period = static_cast<std::int64_t>(labelPalette().size());
  EXPECT_EQ(period, 256);
  EXPECT_EQ(labelColor(1), labelPalette()[0]);
  EXPECT_EQ(labelColor(period), labelPalette()[255]);
  EXPECT_EQ(labelColor(period + 1), labelColor(1));
  EXPECT_EQ(labelColor(-1), labelPalette()[255]);
  EXPECT_EQ(labelColor(-period), labelColor(1));
  labelColor(std::numeric_limits<std::int64_t>::min());
  std::set<std::uint32_t> colors;
  for (std::int64_t i = 0; i <= period; ++i) {
    const Rgba8 color = labelColor(i);
    colors.insert(color.r << 16 | color.g << 8 | color.b);
  }
  EXPECT_EQ(colors.size(), 257u);
}

TEST(LegendTicks, AreRound) {
  EXPECT_THAT(legendTicks(0, 1, 5), ElementsAre(0, 0.2, 0.4, testing::DoubleEq(0.6), 0.8, 1));
  EXPECT_THAT(legendTicks(-3, 12, 3), ElementsAre(0, 5, 10));
  EXPECT_THAT(legendTicks(0.021, 0.039, 2), ElementsAre(testing::DoubleEq(0.03)));
  EXPECT_THAT(legendTicks(1, 1, 5), IsEmpty());
  EXPECT_THAT(legendTicks(0, kNaN, 5), IsEmpty());
  EXPECT_THAT(legendTicks(0, 1, 0), IsEmpty());
}

TEST(LegendTicks, LieInsideOfAnyRange) {
  for (const double low : {-1e300, -7.3, 0.0, 1e-12, 123456.0}) {
    for (const double length : {1e-9, 0.37, 9.99, 1e5, 1e300}) {
      const auto ticks = legendTicks(low, low + length, 6);
      EXPECT_LE(ticks.size(), 13u);
      const bool isResolved = length > 1e-6 * std::abs(low);
      EXPECT_GE(ticks.size(), isResolved ? 3u : 0u) << low << " " << length;
      for (std::size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_GE(ticks[i], low);
        EXPECT_LE(ticks[i], low + length);
        EXPECT_TRUE(i == 0 || ticks[i] > ticks[i - 1]);
      }
    }
  }
}

}  // namespace
}  // namespace stipple
