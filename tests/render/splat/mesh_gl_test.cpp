#include <cmath>
#include <cstdlib>

#include "render/appearance/light.h"
#include "render/splat/gl_renderer.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/mesh_scenes.h"

namespace stipple {
namespace {

using MeshTest = GlTest;

constexpr Rgba8 kColor{180, 120, 90, 0};

Appearance withoutEdges() {
  Appearance appearance;
  appearance.edgeStrength = 0;
  return appearance;
}

// Where the ray through a pixel first meets the unit sphere, in world coordinates; nothing where it misses,
// or nearly.
std::optional<glm::vec3> castOnSphere(const View& view, int x, int y) {
  const glm::vec2 px(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  const glm::vec3 near = view.toWorld(view.fromPixels(px, 1)), far = view.toWorld(view.fromPixels(px, 2));
  const glm::vec3 along = glm::normalize(far - near);
  const float middle = -glm::dot(near, along), off2 = glm::dot(near, near) - middle * middle;
  if (off2 > 0.99f) return {};
  return near + (middle - std::sqrt(1 - off2)) * along;
}

TEST_F(MeshTest, ASphereIsLitAsTheRayCastSays) {
  const scenes::Mesh sphere = scenes::sphereMesh(200, 100, kColor);
  GlRenderer renderer;
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const View view = frameView({}, {.yaw = 0.4f, .pitch = 0.3f, .projection = projection}, 160, 120);
    renderer.drawMesh(sphere.view(), view, withoutEdges(), Accumulate::kStartAnew);
    const Image image = renderer.image();
    int hits = 0;
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const std::optional<glm::vec3> hit = castOnSphere(view, x, y);
        if (!hit) continue;
        ++hits;
        const float shade = light::shade(view.viewFromWorld * *hit);
        EXPECT_NEAR(image.at(x, y).r, encodeSrgb(shade * linearTable()[kColor.r]), 3) << x << ", " << y;
        EXPECT_NEAR(image.at(x, y).b, encodeSrgb(shade * linearTable()[kColor.b]), 3) << x << ", " << y;
      }
    }
    EXPECT_GT(hits, 5000);
    EXPECT_EQ(image.at(0, 0), *Appearance{}.background);
    EXPECT_FALSE(renderer.pick(80, 60)) << "triangles are not nodes";
  }
}

TEST_F(MeshTest, AFloorThatPassesBeneathTheEyeReachesTheHorizon) {
  const scenes::Mesh floor = scenes::squareMesh(1000, kColor);
  View view = frameView({}, {}, 120, 90);  // looks along +y
  view.eye = {0, 0, 0.1f};
  GlRenderer renderer;
  Appearance appearance = withoutEdges();
  appearance.lit = false;
  renderer.drawMesh(floor.view(), view, appearance, Accumulate::kStartAnew);
  const Image image = renderer.image();
  for (int x = 0; x < view.width; ++x) {
    for (int y = 0; y < view.height / 2 - 1; ++y) EXPECT_EQ(image.at(x, y), *appearance.background);
    for (int y = view.height / 2 + 1; y < view.height; ++y) EXPECT_NEAR(image.at(x, y).g, kColor.g, 1);
  }
}

TEST_F(MeshTest, BacksAreDarkWhereLightHasOneSide) {
  const scenes::Mesh square = scenes::squareMesh(3, kColor);
  const View fromBelow = frameView({}, {.pitch = -1.5707963f}, 8, 8);
  GlRenderer renderer;
  Appearance appearance = withoutEdges();
  std::vector<int> reds;
  for (const bool twoSided : {true, false}) {
    appearance.twoSided = twoSided;
    renderer.drawMesh(square.view(), fromBelow, appearance, Accumulate::kStartAnew);
    reds.push_back(renderer.image().at(4, 4).r);
  }
  EXPECT_NEAR(reds[1], encodeSrgb(light::kAmbient * linearTable()[kColor.r]), 1);
  EXPECT_GT(reds[0], reds[1] + 50);
}

TEST_F(MeshTest, NoTrianglesGiveTheBackground) {
  GlRenderer renderer;
  renderer.drawMesh({}, frameView({}, {}, 4, 4), {}, Accumulate::kStartAnew);
  EXPECT_EQ(renderer.image().pixels, std::vector<Rgba8>(16, *Appearance{}.background));
}

}  // namespace
}  // namespace stipple
