#include "app/panels/blend.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace stipple {
namespace {

std::uint32_t word(int r, int g, int b, int a) {
  return std::uint32_t(r) | std::uint32_t(g) << 8 | std::uint32_t(b) << 16 | std::uint32_t(a) << 24;
}

int exactly(int source, int target, int alpha) {
  return static_cast<int>(std::lround((source * alpha + target * (255 - alpha)) / 255.0));
}

TEST(Blend, IsRoundedOnceForEveryAlphaAndChannel) {
  for (int alpha = 0; alpha < 256; ++alpha) {
    for (int target = 0; target < 256; target += 3) {
      std::uint32_t pixel = word(target, 255 - target, 7, 255);
      blendPixel(pixel, {{200, 13, 255}, static_cast<std::uint8_t>(alpha)});
      ASSERT_EQ(pixel, word(exactly(200, target, alpha), exactly(13, 255 - target, alpha),
                            exactly(255, 7, alpha), 255));
    }
  }
}

TEST(Blend, OverNothingIsPremultiplied) {
  std::uint32_t pixel = 0;
  blendPixel(pixel, {{255, 100, 0}, 51});
  EXPECT_EQ(pixel, word(51, 20, 0, 51));
}

TEST(Blend, SpansOfEveryLengthAreThePixelsAndNothingBeside) {
  for (const int alpha : {0, 90, 255}) {
    const SourceColor color{{10, 200, 90}, static_cast<std::uint8_t>(alpha)};
    for (int length = 0; length < 40; ++length) {
      std::vector<std::uint32_t> row(42, word(50, 60, 70, 255));
      std::vector<std::uint32_t> expected = row;
      for (int i = 1; i <= length; ++i) blendPixel(expected[i], color);
      blendSpan(row.data() + 1, length, color);
      ASSERT_EQ(row, expected) << length << " pixels, alpha " << alpha;
    }
  }
}

TEST(Blend, CoverageScalesAlpha) {
  const SourceColor color{{255, 255, 255}, 128};
  std::vector<std::uint32_t> row(3, word(0, 0, 0, 255));
  const std::uint8_t coverage[] = {0, 255, 128};
  blendCoverage(row.data(), 3, color, coverage);
  EXPECT_THAT(row, testing::ElementsAre(word(0, 0, 0, 255), word(128, 128, 128, 255), word(64, 64, 64, 255)));
}

TEST(TimesUnit, IsTheRoundedProduct) {
  for (std::uint32_t a = 0; a < 256; ++a) {
    for (std::uint32_t b = 0; b < 256; ++b) ASSERT_EQ(timesUnit(a, b), std::lround(a * b / 255.0));
  }
}

}  // namespace
}  // namespace stipple
