#include "app/panels/triangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/app/panels/drawing.h"

namespace stipple {
namespace {

constexpr Rgba8 kBlack{0, 0, 0, 255};
constexpr ImU32 kWhite = IM_COL32_WHITE;
// Drawn twice it is seen to be: 64 is no multiple of what it leaves.
constexpr ImU32 kQuarter = IM_COL32(255, 255, 255, 64);
constexpr double kQuarterArea = 64.0 / 255;

TEST(Triangle, CoversTheCentersWithin) {
  // y < x / 2 in a square of 64 pixels: the centers are counted by the same inequality.
  Image image = filledImage(64, 64, kBlack);
  HandDrawing drawing;
  drawing.addTriangle({0, 0}, {64, 0}, {64, 32}, kWhite);
  drawing.draw(image);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      ASSERT_EQ(image.at(x, y).r, y + 0.5 < (x + 0.5) / 2 ? 255 : 0) << x << ' ' << y;
    }
  }
}

TEST(Triangle, WindingDoesNotMatter) {
  const ImVec2 corners[3] = {{3.2f, 5.7f}, {40.1f, 9.9f}, {17.3f, 50.4f}};
  Image first = filledImage(64, 64, kBlack);
  HandDrawing reference;
  reference.addTriangle(corners[0], corners[1], corners[2], kWhite);
  reference.draw(first);
  EXPECT_NEAR(coveredArea(first), 0.5 * std::abs(36.9 * 44.7 - 14.1 * 4.2),
              25);  // half the perimeter's worth
  for (const auto& [i, j, k] : {std::array{1, 2, 0}, {2, 0, 1}, {2, 1, 0}, {0, 2, 1}, {1, 0, 2}}) {
    Image other = filledImage(64, 64, kBlack);
    HandDrawing drawing;
    drawing.addTriangle(corners[i], corners[j], corners[k], kWhite);
    drawing.draw(other);
    EXPECT_EQ(other.pixels, first.pixels);
  }
}

TEST(Triangle, FansLeaveNoGapAndDrawNothingTwice) {
  // Around any center every pixel of the square belongs to exactly one triangle.
  for (int seed = 0; seed < 200; ++seed) {
    const ImVec2 center(32 + 17.3f * std::sin(seed * 1.7f), 32 + 21.9f * std::cos(seed * 2.9f));
    const int corners = 3 + seed % 14;
    Image image = filledImage(64, 64, kBlack);
    HandDrawing drawing;
    drawing.setScissor({8, 8}, {56, 56});
    for (int i = 0; i < corners; ++i) {
      const auto rim = [&](int k) {
        const double angle = 2 * std::numbers::pi * k / corners + seed;
        return ImVec2(32 + 300 * float(std::cos(angle)), 32 + 300 * float(std::sin(angle)));
      };
      drawing.addTriangle(center, rim(i), rim((i + 1) % corners), kQuarter);
    }
    drawing.draw(image);
    for (int y = 8; y < 56; ++y) {
      for (int x = 8; x < 56; ++x) ASSERT_EQ(image.at(x, y).r, 64) << seed << ": " << x << ' ' << y;
    }
    EXPECT_NEAR(coveredArea(image), 48 * 48 * kQuarterArea, 1e-9) << "and nothing beyond the scissor";
  }
}

TEST(Triangle, EdgesThroughCentersBelongToOneSide) {
  // The diagonal of a square through all pixel centers, as two triangles that are not taken for a rectangle.
  Image image = filledImage(16, 16, kBlack);
  HandDrawing drawing;
  drawing.addTriangle({0.5f, 0.5f}, {12.5f, 0.5f}, {12.5f, 12.5f}, kQuarter);
  drawing.addTriangle({0.5f, 0.5f}, {12.5f, 12.5f}, {0.5f, 12.5f}, kQuarter);
  drawing.draw(image);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) ASSERT_EQ(image.at(x, y).r, x < 12 && y < 12 ? 64 : 0) << x << ' ' << y;
  }
}

TEST(Triangle, ColorsVaryLinearly) {
  Image image = filledImage(32, 32, kBlack);
  HandDrawing drawing;
  const ImVec2 uv = HandDrawing::kWhite;
  drawing.addTriangle({{0, 0}, uv, IM_COL32(0, 0, 40, 255)}, {{64, 0}, uv, IM_COL32(255, 0, 40, 255)},
                      {{0, 64}, uv, IM_COL32(0, 128, 40, 255)});
  drawing.draw(image);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x + y < 31; ++x) {
      const Rgba8& pixel = image.at(x, y);
      ASSERT_NEAR(pixel.r, 255 * (x + 0.5) / 64, 0.51);
      ASSERT_NEAR(pixel.g, 128 * (y + 0.5) / 64, 0.51);
      ASSERT_EQ(pixel.b, 40);
    }
  }
}

TEST(Triangle, AFringeCoversHalfOfItsWidth) {
  // A soft edge as Dear ImGui makes it: alpha from full to none.
  Image image = filledImage(100, 10, kBlack);
  HandDrawing drawing;
  const ImVec2 uv = HandDrawing::kWhite;
  const ImU32 none = kWhite & ~IM_COL32_A_MASK;
  drawing.addTriangle({{0, 0}, uv, kWhite}, {{100, 0}, uv, none}, {{100, 10}, uv, none});
  drawing.addTriangle({{0, 0}, uv, kWhite}, {{100, 10}, uv, none}, {{0, 10}, uv, kWhite});
  drawing.draw(image);
  EXPECT_NEAR(coveredArea(image), 500, 1);
}

TEST(Triangle, TextureIsFilteredAndClamped) {
  // The checker's texel centers at (2.5, 2.5) full and (3.5, 2.5) empty: linear between, constant beyond.
  Image image = filledImage(64, 8, kBlack);
  HandDrawing drawing;
  const float v = 2.5f / 4;
  drawing.addTriangle({{0, -100}, {0.5f, v}, kWhite}, {{128, -100}, {1.5f, v}, kWhite},
                      {{0, 200}, {0.5f, v}, kWhite});
  drawing.draw(image);
  for (int x = 0; x < 64; ++x) {
    const double u = 2 + 4 * (x + 0.5) / 128;
    ASSERT_NEAR(image.at(x, 4).r, 255 * std::clamp(3.5 - u, 0.0, 1.0), 1.01) << x;
  }
}

TEST(Triangle, DegenerateOnesDrawNothing) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Image image = filledImage(16, 16, kBlack);
  HandDrawing drawing;
  drawing.addTriangle({2, 2}, {10, 10}, {6, 6}, kWhite);
  drawing.addTriangle({3, 3}, {3, 3}, {3, 3}, kWhite);
  drawing.addTriangle({kNan, 3}, {8, kNan}, {3, 12}, kWhite);
  drawing.addTriangle({3e30f, 3}, {4e30f, 3}, {3e30f, 12}, kWhite);
  drawing.addTriangle({1, 1}, {9, 1}, {5, 9}, IM_COL32(255, 255, 255, 0));
  drawing.draw(image);
  EXPECT_EQ(coveredArea(image), 0);
}

TEST(Rectangle, IsWhatItsTwoTrianglesAre) {
  for (int seed = 0; seed < 100; ++seed) {
    const ImVec2 from(10 + 9 * std::sin(seed * 1.3f), 10 + 9 * std::cos(seed * 2.1f));
    const ImVec2 to(from.x + seed * 0.37f, from.y + seed * 0.29f);
    Image asOne = filledImage(64, 64, kBlack), asTwo = asOne;
    HandDrawing one, two;
    one.addRectangle(from, to, kQuarter);
    two.addTriangle(from, {to.x, from.y}, to, kQuarter);
    two.addTriangle(from, to, {from.x, to.y}, kQuarter);
    one.draw(asOne);
    two.draw(asTwo);
    ASSERT_EQ(asOne.pixels, asTwo.pixels) << seed;
  }
}

TEST(Rectangle, TakesTexelsOneToOneWhereTheyLieOnPixels) {
  Image image = filledImage(8, 8, kBlack);
  HandDrawing drawing;
  drawing.addRectangle({3, 1}, {5, 3}, kWhite, {0.5f, 0.5f}, {1, 1});
  drawing.draw(image);
  EXPECT_EQ(image.at(3, 1).r, 255);
  EXPECT_EQ(image.at(4, 1).r, 0);
  EXPECT_EQ(image.at(3, 2).r, 0);
  EXPECT_EQ(image.at(4, 2).r, 255);
  EXPECT_EQ(coveredArea(image), 2);
}

TEST(Rectangle, FiltersTexelsThatLieBetweenPixels) {
  Image image = filledImage(8, 8, kBlack);
  HandDrawing drawing;
  drawing.addRectangle({3.5f, 1}, {5.5f, 3}, kWhite, {0.5f, 0.5f}, {1, 1});
  drawing.draw(image);
  EXPECT_EQ(image.at(3, 1).r, 255);  // left of the border's center, which is repeated
  EXPECT_EQ(image.at(4, 1).r, 128);
  EXPECT_EQ(image.at(4, 2).r, 128);
}

TEST(Rectangle, OfAGlyphCutByTheScissorStaysInPlace) {
  Image whole = filledImage(8, 8, kBlack), cut = whole;
  HandDrawing drawing, scissored;
  drawing.addRectangle({2, 2}, {6, 6}, kWhite, {0, 0}, {1, 1});
  drawing.draw(whole);
  scissored.setScissor({4, 3}, {8, 8});
  scissored.addRectangle({2, 2}, {6, 6}, kWhite, {0, 0}, {1, 1});
  scissored.draw(cut);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) EXPECT_EQ(cut.at(x, y), x >= 4 && y >= 3 ? whole.at(x, y) : kBlack);
  }
}

}  // namespace
}  // namespace stipple
