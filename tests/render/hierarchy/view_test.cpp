#include "render/hierarchy/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <random>

namespace stipple {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-5f) {
  EXPECT_LT(glm::distance(a, b), tolerance) << a.x << " " << a.y << " " << a.z;
}

glm::vec3 forwardOf(const View& view) {
  return view.toWorld({0, 0, 1}) - view.eye;
}

TEST(View, PixelsAndPlacesAreInverse) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    View view = frameView({{1, 2, 3}, 2}, {.yaw = 0.7f, .pitch = -0.4f, .projection = projection}, 640, 480);
    view.jitterPx = {0.25f, -0.125f};
    for (int i = 0; i < 100; ++i) {
      const glm::vec3 world =
          glm::vec3(1, 2, 3) + glm::vec3(uniform(random), uniform(random), uniform(random));
      const glm::vec3 inView = view.toView(world);
      expectNear(view.toWorld(inView), world);
      expectNear(view.fromPixels(view.toPixels(inView), inView.z), inView);
    }
  }
}

TEST(View, LooksAlongTheStatedDirections) {
  expectNear(forwardOf(frameView({}, {}, 100, 100)), {0, 1, 0});
  expectNear(forwardOf(frameView({}, {.up = UpAxis::kY}, 100, 100)), {0, 0, -1});
  // A quarter to the left, counterclockwise seen from above.
  expectNear(forwardOf(frameView({}, {.yaw = kPi / 2}, 100, 100)), {-1, 0, 0});
  expectNear(forwardOf(frameView({}, {.yaw = kPi / 2, .up = UpAxis::kY}, 100, 100)), {-1, 0, 0});
  // Pitch > 0 looks down.
  expectNear(forwardOf(frameView({}, {.pitch = kPi / 2}, 100, 100)), {0, 0, -1});
  expectNear(forwardOf(frameView({}, {.pitch = kPi / 2, .up = UpAxis::kY}, 100, 100)), {0, -1, 0});
}

TEST(View, IsARotationWithUpAtTheTop) {
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    const View view = frameView({{0, 0, 0}, 1}, {.yaw = 1, .pitch = 0.5f, .up = up}, 200, 100);
    EXPECT_NEAR(glm::determinant(view.viewFromWorld), 1, 1e-5);
    const glm::vec3 upwards = up == UpAxis::kY ? glm::vec3(0, 0.5f, 0) : glm::vec3(0, 0, 0.5f);
    const glm::vec2 center = view.toPixels(view.toView({0, 0, 0})),
                    above = view.toPixels(view.toView(upwards));
    EXPECT_LT(glm::distance(center, glm::vec2(100, 50)), 1e-3f);
    EXPECT_LT(above.y, center.y - 5);  // rows from the top
    EXPECT_NEAR(above.x, center.x, 1e-3);
  }
}

TEST(View, TheSphereJustFitsTheHeight) {
  const FramingSphere sphere{{3, -1, 2}, 2.5f};
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const View view = frameView(sphere, {.yaw = 0.2f, .pitch = 0.6f, .projection = projection}, 300, 200);
    // The highest place of the outline: where the line of sight touches the sphere.
    const float distance = glm::distance(view.eye, sphere.center);
    const float sine = view.isPerspective() ? sphere.radius / distance : 0,
                cosine = std::sqrt(1 - sine * sine);
    const glm::vec3 touching(0, -sphere.radius * cosine, distance - sphere.radius * sine);
    EXPECT_NEAR(view.toPixels(touching).y, 0, 1e-2);
    EXPECT_NEAR(view.pixelsPerUnit(distance) * 1,
                view.isPerspective() ? view.focalPx / distance : 100 / sphere.radius, 1e-3);
  }
}

TEST(View, ZoomComesNearerAndJitterShifts) {
  const View far = frameView({}, {}, 100, 100), near = frameView({}, {.zoom = 2}, 100, 100);
  EXPECT_NEAR(glm::length(near.eye), 0.5f * glm::length(far.eye), 1e-5);
  EXPECT_EQ(near.focalPx, far.focalPx);
  View shifted = far;
  shifted.jitterPx = {0.5f, 0.25f};
  const glm::vec3 p = far.toView({0.1f, 0.2f, 0.3f});
  EXPECT_LT(glm::distance(shifted.toPixels(p) - far.toPixels(p), glm::vec2(0.5f, 0.25f)), 1e-4f);
  const View orthographic = frameView({}, {.zoom = 3, .projection = Projection::kOrthographic}, 100, 100);
  EXPECT_NEAR(orthographic.focalPx, 150,
              1e-3);  // pixels of a unit: half the height over the radius, times zoom
}

}  // namespace
}  // namespace stipple
