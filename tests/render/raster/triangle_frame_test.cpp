#include "render/raster/triangle_frame.h"

#include <gtest/gtest.h>

#include "render/appearance/kernel.h"
#include "render/appearance/light.h"

namespace stipple {
namespace {

/// A square that faces the viewer, or turns its back.
class TriangleFrame : public testing::Test {
 protected:
  glm::vec4 middleOf(float normalY, const Rgba8& color, Appearance appearance) {
    appearance.edgeStrength = 0;
    const std::vector<Eigen::Vector3f> normals(4, Eigen::Vector3f(0, normalY, 0));
    const std::vector<Rgba8> colors(4, color);
    const View view = frameView({{0, 0, 0}, 2}, {}, 16, 16);
    drawTriangles({positions_, normals, colors, triangles_}, view, appearance, layer_, frame_, nullptr);
    EXPECT_EQ(frame_.light[0], glm::vec4(0)) << "nothing beside it";
    return frame_.light[frame_.at(8, 8)];
  }

  const std::vector<Eigen::Vector3f> positions_ = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
  const std::vector<Triangle> triangles_ = {{0, 1, 2}, {0, 2, 3}};
  MeshLayer layer_;
  FrameBuffers frame_;
};

TEST_F(TriangleFrame, IsLitFromOverTheShoulder) {
  const glm::vec4 seen = middleOf(-1, {255, 255, 255, 0}, {});
  const float expected = light::shade({0, 0, -1});
  EXPECT_NEAR(seen.r, expected, 1e-4);
  EXPECT_EQ(seen.a, 1);
  EXPECT_NEAR(frame_.depth[frame_.at(8, 8)], 2 / std::sin(kFieldOfView / 2), 1e-4);
  EXPECT_EQ(frame_.nodes[frame_.at(8, 8)], FrameBuffers::kNoNode);
}

TEST_F(TriangleFrame, BacksAreDarkWhereOneSideIsLit) {
  const glm::vec4 front = middleOf(-1, {255, 255, 255, 0}, {});
  EXPECT_NEAR(middleOf(1, {255, 255, 255, 0}, {}).r, front.r, 1e-4);
  EXPECT_NEAR(middleOf(1, {255, 255, 255, 0}, {.twoSided = false}).r, light::shade({0, 0, 1}), 1e-4);
  EXPECT_LT(middleOf(1, {255, 255, 255, 0}, {.twoSided = false}).r, 0.5F * front.r);
}

TEST_F(TriangleFrame, ShowsColorsAsTheyAreWithoutLight) {
  const glm::vec4 seen = middleOf(-1, {255, 0, 128, 0}, {.lit = false});
  EXPECT_NEAR(seen.r, 1, 1e-5);
  EXPECT_NEAR(seen.g, 0, 1e-5);
  EXPECT_NEAR(seen.b, linearFromSrgb(128 / 255.F), 1e-5);
}

TEST_F(TriangleFrame, TakesOnTheColorOfTheSelection) {
  const glm::vec4 seen = middleOf(-1, {0, 0, 0, 255}, {.lit = false, .selectionColor = {255, 255, 255, 255}});
  EXPECT_NEAR(seen.r, kernel::kSelectionShare, 1e-5);
}

}  // namespace
}  // namespace stipple
