#include "app/tools/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace stipple {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr PictureSize kSize{800, 600};
const FramingSphere kModel{{10, -20, 5}, 3};
constexpr Projection kProjections[] = {Projection::kPerspective, Projection::kOrthographic};

OrbitCamera framedCamera(Projection projection, UpAxis up = UpAxis::kZ) {
  OrbitCamera camera(up);
  if (projection == Projection::kOrthographic) camera.toggleProjection();
  camera.frame(kModel);
  return camera;
}

glm::vec2 pixelOf(const OrbitCamera& camera, const glm::vec3& place) {
  const View view = camera.view(kSize);
  return view.toPixels(view.toView(place));
}

float depthOf(const OrbitCamera& camera, const glm::vec3& place) {
  return camera.view(kSize).toView(place).z;
}

void expectSamePixel(const glm::vec2& a, const glm::vec2& b, float tolerance = 0.02f) {
  EXPECT_LT(glm::distance(a, b), tolerance) << a.x << " " << a.y << " and " << b.x << " " << b.y;
}

void expectSamePicture(const View& a, const View& b) {
  EXPECT_LT(glm::distance(a.eye, b.eye), 1e-5f * (1 + glm::length(b.eye)));
  for (int column = 0; column < 3; ++column)
    EXPECT_LT(glm::distance(a.viewFromWorld[column], b.viewFromWorld[column]), 1e-6f);
  EXPECT_EQ(a.projection, b.projection);
  EXPECT_NEAR(a.focalPx, b.focalPx, 1e-5f * b.focalPx);
  EXPECT_NEAR(a.nearDepth, b.nearDepth, 1e-5f * b.nearDepth);
}

class Places {
 public:
  explicit Places(unsigned seed) : random_(seed) {}
  float within(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  glm::vec2 pixel() { return {within(0, 800), within(0, 600)}; }
  glm::vec3 onModel() {
    return kModel.center + 0.5f * kModel.radius * glm::vec3(within(-1, 1), within(-1, 1), within(-1, 1));
  }

 private:
  std::mt19937 random_;
};

TEST(OrbitCamera, FramesAsFrameViewDoes) {
  for (const Projection projection : kProjections) {
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      OrbitCamera camera = framedCamera(projection, up);
      camera.turnTo(0.7f, -0.3f);
      expectSamePicture(
          camera.view(kSize),
          frameView(kModel, {.yaw = 0.7f, .pitch = -0.3f, .up = up, .projection = projection}, 800, 600));
      camera.orbit({31, 17}, kSize);
      camera.pan({0, 0}, {50, 20}, 4, kSize);
      camera.zoomToward({100, 100}, 5, 3, kSize);
      camera.turnTo(0.7f, -0.3f);
      camera.frame(kModel);
      expectSamePicture(
          camera.view(kSize),
          frameView(kModel, {.yaw = 0.7f, .pitch = -0.3f, .up = up, .projection = projection}, 800, 600));
    }
  }
}

TEST(OrbitCamera, LeavesThePivotAtItsPixelWhereverItIs) {
  for (const Projection projection : kProjections) {
    OrbitCamera camera = framedCamera(projection);
    Places places(1);
    for (int i = 0; i < 200; ++i) {
      ASSERT_TRUE(camera.setPivot(places.onModel()));
      const glm::vec2 before = pixelOf(camera, camera.pivot());
      camera.orbit({places.within(-300, 300), places.within(-300, 300)}, kSize);
      expectSamePixel(pixelOf(camera, camera.pivot()), before);
    }
  }
}

TEST(OrbitCamera, TurnsTheFrontOfTheModelWithTheDrag) {
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    OrbitCamera camera = framedCamera(Projection::kPerspective, up);
    const View view = camera.view(kSize);
    const glm::vec3 front = view.toWorld({0, 0, camera.pivotDepth() - kModel.radius});
    camera.orbit({20, 10}, kSize);
    EXPECT_GT(pixelOf(camera, front).x, 401);
    EXPECT_GT(pixelOf(camera, front).y, 301);
    // Half a turn a picture's height.
    camera.turnTo(0, 0);
    camera.orbit({-300, 0}, kSize);
    EXPECT_NEAR(camera.yaw(), kPi / 2, 1e-5f);
  }
}

TEST(OrbitCamera, DoesNotTurnOverThePoles) {
  OrbitCamera camera = framedCamera(Projection::kPerspective);
  camera.orbit({0, 5000}, kSize);
  EXPECT_FLOAT_EQ(camera.pitch(), kPi / 2);
  camera.orbit({0, -10}, kSize);
  EXPECT_LT(camera.pitch(), kPi / 2);
  camera.orbit({0, -5000}, kSize);
  EXPECT_FLOAT_EQ(camera.pitch(), -kPi / 2);
  for (int i = 0; i < 100; ++i) camera.orbit({500, 0}, kSize);
  EXPECT_LE(std::abs(camera.yaw()), kPi);
}

TEST(OrbitCamera, PansSoThatWhatIsDraggedFollowsTheCursor) {
  for (const Projection projection : kProjections) {
    OrbitCamera camera = framedCamera(projection);
    Places places(2);
    for (int i = 0; i < 200; ++i) {
      camera.turnTo(places.within(-3, 3), places.within(-1.5f, 1.5f));
      const glm::vec3 place = places.onModel();
      const glm::vec2 from = pixelOf(camera, place), to = places.pixel();
      camera.pan(from, to, depthOf(camera, place), kSize);
      expectSamePixel(pixelOf(camera, place), to);
    }
  }
}

TEST(OrbitCamera, ZoomsTowardWhatIsUnderTheCursor) {
  for (const Projection projection : kProjections) {
    Places places(3);
    for (int i = 0; i < 200; ++i) {
      OrbitCamera camera = framedCamera(projection);
      camera.turnTo(places.within(-3, 3), places.within(-1.5f, 1.5f));
      camera.setPivot(places.onModel());
      const glm::vec3 place = places.onModel();
      const glm::vec2 under = pixelOf(camera, place);
      const float scale = camera.view(kSize).pixelsPerUnit(depthOf(camera, place));
      const float steps = places.within(-8, 8);
      camera.zoomToward(under, depthOf(camera, place), steps, kSize);
      expectSamePixel(pixelOf(camera, place), under, 0.05f);
      const float grown = camera.view(kSize).pixelsPerUnit(depthOf(camera, place)) / scale;
      EXPECT_NEAR(grown, std::pow(1.2f, steps), 1e-3f * grown);
    }
  }
}

TEST(OrbitCamera, ZoomHasLimitsOnBothSides) {
  for (const Projection projection : kProjections) {
    OrbitCamera camera = framedCamera(projection);
    camera.zoomToward({400, 300}, camera.pivotDepth(), 1000, kSize);
    EXPECT_NEAR(camera.pivotDepth(), 1e-3f * kModel.radius, 1e-6f);
    EXPECT_LT(camera.view(kSize).nearDepth, camera.pivotDepth());
    camera.zoomToward({400, 300}, camera.pivotDepth(), 1, kSize);
    EXPECT_NEAR(camera.pivotDepth(), 1e-3f * kModel.radius, 1e-6f);
    camera.zoomToward({400, 300}, camera.pivotDepth(), -1000, kSize);
    EXPECT_NEAR(camera.pivotDepth(), 50 * kModel.radius, 1e-2f);
    camera.zoomToward({400, 300}, camera.pivotDepth(), -1, kSize);
    EXPECT_NEAR(camera.pivotDepth(), 50 * kModel.radius, 1e-2f);
  }
}

TEST(OrbitCamera, NeverPassesThePivot) {
  OrbitCamera camera = framedCamera(Projection::kPerspective);
  const glm::vec3 behind = kModel.center + glm::vec3(0.5f, 2.5f, 0.2f);  // it looks along +Y
  ASSERT_GT(depthOf(camera, behind), camera.pivotDepth());
  for (int i = 0; i < 100; ++i) {
    const glm::vec2 under = pixelOf(camera, behind);
    camera.zoomToward(under, depthOf(camera, behind), 1, kSize);
    ASSERT_GT(camera.pivotDepth(), 0);
    // At the nearest, a last bit of the eye's float coordinates is .3 pixels.
    expectSamePixel(pixelOf(camera, behind), under, 0.6f);
  }
  // On its way it was taken for the pivot.
  EXPECT_LT(glm::distance(camera.pivot(), behind), 1e-3f);
}

TEST(OrbitCamera, SetsThePivotWithoutAJump) {
  for (const Projection projection : kProjections) {
    OrbitCamera camera = framedCamera(projection);
    camera.turnTo(0.4f, 0.9f);
    camera.pan({0, 0}, {120, -40}, camera.pivotDepth(), kSize);
    const View before = camera.view(kSize);
    ASSERT_TRUE(camera.setPivot(kModel.center + glm::vec3(1, -0.5f, 0.3f)));
    View after = camera.view(kSize);
    after.nearDepth = before.nearDepth;  // follows the distance of the pivot
    expectSamePicture(after, before);
  }
}

TEST(OrbitCamera, TakesNoPivotBehindTheEye) {
  OrbitCamera camera = framedCamera(Projection::kPerspective);
  const glm::vec3 pivot = camera.pivot();
  EXPECT_FALSE(camera.setPivot(camera.eye() - glm::vec3(0, 1, 0)));
  EXPECT_FALSE(camera.setPivot(camera.eye()));
  EXPECT_EQ(camera.pivot(), pivot);
}

TEST(OrbitCamera, TogglesTheProjectionAtTheSizeOfThePivot) {
  OrbitCamera camera = framedCamera(Projection::kPerspective);
  camera.turnTo(1, 0.5f);
  camera.zoomToward({200, 100}, 4, 2, kSize);
  camera.setPivot(kModel.center + glm::vec3(0.3f, 0.2f, -0.4f));
  const View before = camera.view(kSize);
  const float scale = before.pixelsPerUnit(camera.pivotDepth());
  const glm::vec2 pixel = pixelOf(camera, camera.pivot());
  camera.toggleProjection();
  EXPECT_FALSE(camera.view(kSize).isPerspective());
  EXPECT_NEAR(camera.view(kSize).focalPx, scale, 1e-4f * scale);
  expectSamePixel(pixelOf(camera, camera.pivot()), pixel);
  camera.toggleProjection();
  expectSamePicture(camera.view(kSize), before);
}

TEST(OrbitCamera, AllOfTheModelIsBeforeAnOrthographicEye) {
  OrbitCamera camera = framedCamera(Projection::kOrthographic);
  Places places(4);
  for (int i = 0; i < 100; ++i) {
    camera.setPivot(places.onModel());
    camera.orbit({places.within(-300, 300), places.within(-300, 300)}, kSize);
    camera.zoomToward(places.pixel(), 1, places.within(-5, 8), kSize);
    EXPECT_GT(depthOf(camera, kModel.center), kModel.radius);
  }
}

TEST(OrbitCamera, ShowsTheSides) {
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    OrbitCamera camera = framedCamera(Projection::kPerspective, up);
    const auto forward = [&](AxisView side) {
      camera.show(side);
      const View view = camera.view(kSize);
      return view.toWorld({0, 0, 1}) - view.eye;
    };
    const glm::vec3 above = up == UpAxis::kY ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 ahead = up == UpAxis::kY ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    EXPECT_LT(glm::distance(forward(AxisView::kFront), ahead), 1e-5f);
    EXPECT_LT(glm::distance(forward(AxisView::kBack), -ahead), 1e-5f);
    EXPECT_LT(glm::distance(forward(AxisView::kRight), glm::vec3(-1, 0, 0)), 1e-5f);
    EXPECT_LT(glm::distance(forward(AxisView::kLeft), glm::vec3(1, 0, 0)), 1e-5f);
    EXPECT_LT(glm::distance(forward(AxisView::kTop), -above), 1e-5f);
    EXPECT_LT(glm::distance(forward(AxisView::kBottom), above), 1e-5f);
  }
}

bool isFinite(const View& view) {
  bool finite = std::isfinite(view.focalPx) && std::isfinite(view.nearDepth);
  for (int axis = 0; axis < 3; ++axis) {
    finite = finite && std::isfinite(view.eye[axis]);
    for (int column = 0; column < 3; ++column)
      finite = finite && std::isfinite(view.viewFromWorld[column][axis]);
  }
  return finite;
}

TEST(OrbitCamera, StaysFiniteWhateverHappens) {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  for (const Projection projection : kProjections) {
    OrbitCamera camera = framedCamera(projection);
    const View before = camera.view(kSize);
    for (const float bad : {nan, infinite, -infinite}) {
      camera.orbit({bad, 0}, kSize);
      camera.pan({bad, 0}, {0, bad}, 1, kSize);
      camera.zoomToward({0, bad}, 1, 1, kSize);
      camera.zoomToward({0, 0}, 1, bad, kSize);
      camera.turnTo(bad, bad);
      camera.frame({{bad, 0, 0}, 1});
      camera.frame({{0, 0, 0}, bad});
      camera.setModel({{0, 0, 0}, bad});
      EXPECT_FALSE(camera.setPivot({bad, 0, 0}));
    }
    camera.orbit({10, 10}, {0, 0});
    camera.pan({10, 10}, {20, 20}, 1, {0, 0});
    camera.zoomToward({10, 10}, 1, 1, {0, 0});
    expectSamePicture(camera.view(kSize), before);
    EXPECT_TRUE(isFinite(camera.view({0, 0})));

    // Depths that cannot be are those of the pivot.
    for (const float depth : {nan, infinite, 0.f, -1.f}) {
      camera.pan({10, 10}, {40, 20}, depth, kSize);
      camera.zoomToward({10, 10}, depth, 2, kSize);
    }
    camera.frame({{1, 2, 3}, 0});  // a single point
    EXPECT_TRUE(isFinite(camera.view(kSize)));

    Places places(5);
    camera.frame(kModel);
    for (int i = 0; i < 2000; ++i) {
      camera.zoomToward(places.pixel(), places.within(0, 20), places.within(-30, 30), kSize);
      camera.orbit(places.pixel(), kSize);
      camera.setPivot(places.onModel());
      if (i % 7 == 0) camera.toggleProjection();
      ASSERT_TRUE(isFinite(camera.view(kSize))) << i;
      ASSERT_GT(camera.pivotDepth(), 0) << i;
    }
  }
}

}  // namespace
}  // namespace stipple
