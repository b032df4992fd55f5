#include "render/appearance/splat_colors.h"

#include <gmock/gmock.h>

#include <limits>

#include "render/appearance/light.h"

namespace stipple {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

PointSet pointsWith(const std::string& name, AttributeValues values) {
  const std::size_t count = std::visit([](const auto& v) { return v.size(); }, values);
  PointSet points(std::vector<Eigen::Vector3f>(count, Eigen::Vector3f::Zero()));
  points.set(name, std::move(values));
  return points;
}

Rgba8 unselected(Rgba8 color) {
  color.a = 0;
  return color;
}

template <class Action>
std::string refusalOf(Action action) {
  try {
    action();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

TEST(RangeOf, LeavesOutWhatIsNotFinite) {
  EXPECT_THAT(rangeOf(pointsWith("a", std::vector<float>{2, kNaN, -3, kInfinity, 1}), "a"), Pair(-3, 2));
  EXPECT_THAT(rangeOf(pointsWith("a", std::vector<double>{1e300, -1e300}), "a"), Pair(-1e300, 1e300));
  EXPECT_THAT(rangeOf(pointsWith("a", std::vector<std::uint32_t>{4000000000u, 1}), "a"), Pair(1, 4e9));
}

TEST(RangeOf, IsNeverOfZeroLength) {
  EXPECT_THAT(rangeOf(pointsWith("a", std::vector<float>{}), "a"), Pair(0, 1));
  EXPECT_THAT(rangeOf(pointsWith("a", std::vector<float>{kNaN, -kInfinity}), "a"), Pair(0, 1));
  for (const float constant : {0.F, 5.F, -2e9F, 3e38F}) {
    const auto [low, high] = rangeOf(pointsWith("a", std::vector<float>{constant}), "a");
    EXPECT_LT(low, constant);
    EXPECT_GT(high, constant);
  }
}

TEST(RangeOf, RefusesWhatHasNone) {
  const PointSet points = pointsWith("heat", std::vector<Eigen::Vector3f>{Eigen::Vector3f::UnitX()});
  EXPECT_THAT(refusalOf([&] { rangeOf(points, "cold"); }), HasSubstr("no attribute 'cold'"));
  EXPECT_THAT(refusalOf([&] { rangeOf(points, "heat"); }), HasSubstr("'heat' is a vector3"));
}

TEST(ColorPoints, KeepColorsAndAreLightGrayWithout) {
  const std::vector<Rgba8> colors = {{1, 2, 3, 255}, {250, 128, 7, 9}};
  const PointSet colored = pointsWith("color", colors);
  EXPECT_THAT(colorPoints(colored, {}), ElementsAre(Rgba8{1, 2, 3, 0}, Rgba8{250, 128, 7, 0}));
  EXPECT_EQ(colorPoints(colored, {.attribute = "color"}), colorPoints(colored, {}));
  const PointSet paint = pointsWith("paint", colors);
  EXPECT_EQ(colorPoints(paint, {.attribute = "paint"}), colorPoints(colored, {}));
  const auto plain = colorPoints(paint, {});
  EXPECT_THAT(plain, Each(plain[0]));
  EXPECT_EQ(plain[0].r, plain[0].g);
  EXPECT_GT(plain[0].r, 180);
}

TEST(ColorPoints, GoThroughTheColormap) {
  const PointSet points = pointsWith("heat", std::vector<float>{-1, 0, 1, kNaN, kInfinity});
  const auto mapped = [&](double t) { return unselected(mapColor(Colormap::kTurbo, t)); };
  EXPECT_THAT(colorPoints(points, {.attribute = "heat", .colormap = Colormap::kTurbo}),
              ElementsAre(mapped(0), mapped(0.5), mapped(1), Rgba8{128, 128, 128, 0}, mapped(1)));
  EXPECT_THAT(
      colorPoints(points, {.attribute = "heat", .colormap = Colormap::kTurbo, .range = std::pair(0.0, 2.0)}),
      ElementsAre(mapped(0), mapped(0), mapped(0.5), Rgba8{128, 128, 128, 0}, mapped(1)));
  EXPECT_EQ(colorPoints(points, {.attribute = "heat"})[0], unselected(mapColor(Colormap::kViridis, 0)));
}

TEST(ColorPoints, ShowLabelsInThePalette) {
  const std::vector<std::int32_t> labels = {0, 1, 2, 300, -1};
  const auto inPalette =
      ElementsAre(unselected(labelColor(0)), unselected(labelColor(1)), unselected(labelColor(2)),
                  unselected(labelColor(300)), unselected(labelColor(-1)));
  EXPECT_THAT(colorPoints(pointsWith("segment", labels), {.attribute = "segment"}), inPalette);
  EXPECT_THAT(colorPoints(pointsWith("kind", labels), {.attribute = "kind"}), inPalette);
  // Whoever names a colormap or a range wants to see amounts.
  const auto asAmounts =
      colorPoints(pointsWith("kind", labels), {.attribute = "kind", .colormap = Colormap::kGray});
  EXPECT_EQ(asAmounts[3], (Rgba8{255, 255, 255, 0}));
  EXPECT_EQ(asAmounts[4], (Rgba8{0, 0, 0, 0}));
  EXPECT_EQ(colorPoints(pointsWith("kind", labels), {.attribute = "kind", .range = std::pair(0.0, 1.0)})[3],
            unselected(mapColor(Colormap::kViridis, 1)));
}

TEST(ColorPoints, ShowManyOrLargeWholeNumbersAsAmounts) {
  std::vector<std::uint32_t> many(4097);
  for (Index i = 0; i < many.size(); ++i) many[i] = 7 * i;
  EXPECT_EQ(colorPoints(pointsWith("time", many), {.attribute = "time"})[0],
            unselected(mapColor(Colormap::kViridis, 0)));
  EXPECT_EQ(colorPoints(pointsWith("label_x", many), {.attribute = "label_x"})[0], unselected(labelColor(0)));
  const std::vector<std::int32_t> large = {0, (1 << 20) + 1};
  EXPECT_EQ(colorPoints(pointsWith("time", large), {.attribute = "time"})[1],
            unselected(mapColor(Colormap::kViridis, 1)));
}

TEST(ColorPoints, ShowDirections) {
  const PointSet points = pointsWith(
      "normal", std::vector<Eigen::Vector3f>{
                    {3, 0, 0}, {0, -1e-30F, 0}, {0, 0, 1e30F}, {0, 0, 0}, {kNaN, 0, 0}, {0, kInfinity, 0}});
  const Rgba8 none{128, 128, 128, 0};
  EXPECT_THAT(
      colorPoints(points, {.attribute = "normal"}),
      ElementsAre(Rgba8{255, 128, 128, 0}, Rgba8{128, 0, 128, 0}, Rgba8{128, 128, 255, 0}, none, none, none));
}

TEST(ColorPoints, FadeToGrayOfTheSameLuminance) {
  PointSet points = pointsWith("color", std::vector<Rgba8>(4, Rgba8{200, 40, 90, 255}));
  points.set("trust", std::vector<float>{0, 1, 2, kNaN});
  const auto colors = colorPoints(points, {.saturationBy = "trust"});
  EXPECT_EQ(colors[2], (Rgba8{200, 40, 90, 0}));
  EXPECT_EQ(colors[0].r, colors[0].g);
  EXPECT_EQ(colors[0].g, colors[0].b);
  EXPECT_EQ(colors[3], colors[0]);
  const auto luminance = [](const Rgba8& c) {
    return 0.2126 * linearFromSrgb(c.r / 255.F) + 0.7152 * linearFromSrgb(c.g / 255.F) +
           0.0722 * linearFromSrgb(c.b / 255.F);
  };
  for (const Rgba8& color : colors) EXPECT_NEAR(luminance(color), luminance(colors[2]), 0.004);
  EXPECT_LT(colors[1].r, colors[2].r);
  EXPECT_GT(colors[1].r, colors[1].g);
}

TEST(ColorPoints, SayInAlphaWhatIsSelected) {
  PointSet points = pointsWith("color", std::vector<Rgba8>(3, Rgba8{1, 2, 3, 255}));
  points.set("mask", std::vector<float>{0, kNaN, -1});
  const auto colors = colorPoints(points, {.selection = "mask"});
  EXPECT_THAT(colors, ElementsAre(Rgba8{1, 2, 3, 0}, Rgba8{1, 2, 3, 255}, Rgba8{1, 2, 3, 255}));
}

TEST(ColorPoints, RefuseWhatCannotBeShown) {
  PointSet points = pointsWith("normal", std::vector<Eigen::Vector3f>{Eigen::Vector3f::UnitX()});
  points.set("heat", std::vector<float>{1});
  const auto refusal = [&](const ColorSource& source) {
    return refusalOf([&] { colorPoints(points, source); });
  };
  EXPECT_THAT(refusal({.attribute = "cold"}), HasSubstr("'cold'"));
  EXPECT_THAT(refusal({.saturationBy = "cold"}), HasSubstr("'cold'"));
  EXPECT_THAT(refusal({.saturationBy = "normal"}), HasSubstr("'normal' is a vector3"));
  EXPECT_THAT(refusal({.selection = "cold"}), HasSubstr("'cold'"));
  EXPECT_THAT(refusal({.attribute = "heat", .range = std::pair(1.0, 1.0)}), HasSubstr("from 1 to 1"));
}

}  // namespace
}  // namespace stipple
