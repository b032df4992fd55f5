#include "render/raster/glyphs.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace stipple {
namespace {

using testing::Each;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

PointSet sphere(int count) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<Eigen::Vector3f> positions;
  for (int i = 0; i < count; ++i)
    positions.push_back(Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized());
  PointSet points(positions);
  points.set("normal", positions);
  return points;
}

float lengthOf(const Glyph& glyph) {
  return glm::length(glyph.to - glyph.from);
}

TEST(MakeGlyphs, SpreadAsManyAsWantedEvenly) {
  const auto glyphs = makeGlyphs(sphere(100000), "normal", {.count = 500});
  EXPECT_GT(glyphs.size(), 430u);
  EXPECT_LT(glyphs.size(), 570u);
  const float length = lengthOf(glyphs[0]);
  // Discs of half that distance, side by side, cover much of the sphere but less than a packing can.
  const double cover = static_cast<double>(glyphs.size()) * length * length / 16;
  EXPECT_GT(cover, 0.45);
  EXPECT_LT(cover, 0.91);
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    EXPECT_NEAR(lengthOf(glyphs[i]), length, 1e-5);
    EXPECT_NEAR(glm::dot(glyphs[i].from, glyphs[i].to - glyphs[i].from), length, 1e-5) << "along the normal";
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE(glm::length(glyphs[i].from - glyphs[j].from), 0.999F * length);
  }
}

TEST(MakeGlyphs, AreAllPointsWhereThereAreFew) {
  EXPECT_THAT(makeGlyphs(sphere(40), "normal", {.count = 100}), SizeIs(40));
  EXPECT_THAT(makeGlyphs(sphere(1), "normal", {}), SizeIs(1));
}

TEST(MakeGlyphs, AreAsLongAsTheirVectors) {
  PointSet points = sphere(100);
  std::vector<Eigen::Vector3f> force(100, Eigen::Vector3f(0, 0, 2e-30F));
  force[7] *= 0.5F;
  force[8] *= 1000;
  points.set("force", force);
  const auto one = makeGlyphs(points, "force", {}), three = makeGlyphs(points, "force", {.length = 3});
  ASSERT_THAT(one, SizeIs(100));
  EXPECT_NEAR(lengthOf(one[7]) / lengthOf(one[0]), 0.5, 1e-3);
  EXPECT_NEAR(lengthOf(one[8]) / lengthOf(one[0]), 1, 1e-3) << "outliers are cut";
  EXPECT_NEAR(lengthOf(three[0]) / lengthOf(one[0]), 3, 1e-3);
}

TEST(MakeGlyphs, LeaveOutWhatHasNoDirection) {
  PointSet points = sphere(5);
  points.set("force",
             std::vector<Eigen::Vector3f>{{0, 0, 0}, {kNaN, 0, 0}, {kInfinity, 0, 0}, {0, 1, 0}, {0, 0, 0}});
  EXPECT_THAT(makeGlyphs(points, "force", {}), SizeIs(1));
  points.set("force", std::vector<Eigen::Vector3f>(5, Eigen::Vector3f::Zero()));
  EXPECT_THAT(makeGlyphs(points, "force", {}), IsEmpty());
  PointSet pile(std::vector<Eigen::Vector3f>(9, Eigen::Vector3f(1, 2, 3)));
  pile.set("force", std::vector<Eigen::Vector3f>(9, Eigen::Vector3f::UnitX()));
  EXPECT_THAT(makeGlyphs(pile, "force", {}), SizeIs(1));
}

TEST(MakeGlyphs, RefuseWhatIsNoVector) {
  PointSet points = sphere(5);
  points.set("heat", std::vector<float>(5, 1));
  EXPECT_THROW(makeGlyphs(points, "heat", {}), InvalidInput);
  EXPECT_THROW(makeGlyphs(points, "cold", {}), InvalidInput);
}

// Pixels are units of the world, x to the right, z up; the middle of the picture is the origin.
View mapView(int side) {
  View view = frameView({{0, 0, 0}, 1}, {.projection = Projection::kOrthographic}, side, side);
  view.focalPx = 1;
  return view;
}

Image filled(int side, const Rgba8& color) {
  return {side, side, std::vector<Rgba8>(static_cast<std::size_t>(side) * side, color)};
}

TEST(DrawGlyphs, CoverTheirLengthTimesTheirWidth) {
  const View view = mapView(64);
  for (const float angle : {0.F, 0.3F, 0.8F, 1.5F, 2.5F}) {
    Image image = filled(64, {0, 0, 0, 0});
    const glm::vec3 half = 20.F * glm::vec3(std::cos(angle), 0, std::sin(angle));
    const std::vector<Glyph> line = {{-half, half}};
    drawGlyphs(image, {}, view, line, {255, 255, 255, 255});
    double cover = 0;
    for (const Rgba8& pixel : image.pixels) cover += pixel.a / 255.0;
    EXPECT_NEAR(cover, 40 * 1.2, 3) << angle;
    EXPECT_EQ(image.at(2, 2).a, 0);
  }
}

TEST(DrawGlyphs, HideWhatLiesBehindTheSurface) {
  const View view = mapView(64);
  const float surface = 2;  // depth of the origin
  std::vector<float> depth(64 * 64, surface);
  for (int y = 0; y < 64; ++y) {
    for (int x = 32; x < 64; ++x) depth[y * 64 + x] = surface - 50;
  }
  Image image = filled(64, {0, 0, 255, 255});
  const std::vector<Glyph> line = {{{-20, 0, 0.5F}, {20, 0, 0.5F}}};
  drawGlyphs(image, depth, view, line, {255, 0, 0, 255});
  EXPECT_EQ(image.at(20, 31), (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(image.at(44, 31), (Rgba8{0, 0, 255, 255}));
  EXPECT_EQ(image.at(20, 40), (Rgba8{0, 0, 255, 255}));
}

TEST(DrawGlyphs, EndWhereTheEyeIs) {
  const View view = frameView({{0, 0, 0}, 1}, {}, 64, 64);
  Image image = filled(64, {0, 0, 0, 255});
  const std::vector<Glyph> lines = {{{0, 0, 0}, {0.1F, -100, 0}},  // through the picture to behind the eye
                                    {{0, -50, 0}, {0, -60, 0}},    // behind the eye
                                    {{0, 0, 0}, {1e6F, 0, 1e6F}},
                                    {{kNaN, 0, 0}, {0, 0, 0}},
                                    {{0, 0, 0.5F}, {0, 0, 0.5F}}};
  drawGlyphs(image, {}, view, lines, {255, 255, 255, 255});
  EXPECT_EQ(image.at(50, 13), (Rgba8{255, 255, 255, 255})) << "up and to the right";
  EXPECT_EQ(image.at(13, 50), (Rgba8{0, 0, 0, 255}));
  EXPECT_GT(image.at(40, 32).r, 100) << "towards the eye and to the right";
}

}  // namespace
}  // namespace stipple
