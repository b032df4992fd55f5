#include "app/tools/navigation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace stipple {
namespace {

constexpr PictureSize kSize{800, 600};

/// A camera before the plane y = 0, seen from -Y; only what is right of the middle is surface.
class NavigationTest : public testing::Test {
 protected:
  NavigationTest() { camera_.frame({{0, 0, 0}, 2}); }

  std::optional<Picked> pickAt(const glm::vec2& px) const {
    ++picks_;
    const View view = camera_.view(kSize);
    const glm::vec3 ray = view.toWorld(view.fromPixels(px, 1)) - view.eye;
    const float depth = (0.5f - view.eye.y) / ray.y;  // the plane y = .5
    if (px.x < 400 || depth <= 0) return std::nullopt;
    return Picked{view.eye + depth * ray, depth};
  }
  bool send(const PointerEvent& event) {
    return navigation_.handle(event, camera_, kSize, [this](const glm::vec2& px) { return pickAt(px); });
  }
  bool press(const glm::vec2& px, PointerButton button, Modifiers modifiers = {}) {
    return send({.action = PointerAction::kPress, .px = px, .button = button, .modifiers = modifiers});
  }
  bool release(const glm::vec2& px, PointerButton button) {
    return send({.action = PointerAction::kRelease, .px = px, .button = button});
  }
  bool move(const glm::vec2& px) { return send({.px = px}); }
  glm::vec2 pixelOf(const glm::vec3& place) const {
    const View view = camera_.view(kSize);
    return view.toPixels(view.toView(place));
  }

  OrbitCamera camera_;
  Navigation navigation_;
  mutable int picks_ = 0;
};

TEST_F(NavigationTest, LeftDragsOrbit) {
  EXPECT_FALSE(move({10, 10})) << "no button is down";
  EXPECT_FALSE(press({100, 100}, PointerButton::kLeft));
  EXPECT_TRUE(move({160, 130}));
  EXPECT_FALSE(move({160, 130})) << "it stands still";
  EXPECT_LT(camera_.yaw(), 0);
  EXPECT_GT(camera_.pitch(), 0);
  EXPECT_FALSE(release({160, 130}, PointerButton::kLeft));
  EXPECT_FALSE(move({300, 300}));
}

TEST_F(NavigationTest, OtherDragsPanWhatTheyHit) {
  const glm::vec2 from(600, 200), to(350, 420);
  for (const auto& [button, shift] : {std::pair{PointerButton::kMiddle, false},
                                      {PointerButton::kRight, false},
                                      {PointerButton::kLeft, true}}) {
    camera_.frame({{0, 0, 0}, 2});
    const glm::vec3 hit = pickAt(from)->position;
    press(from, button, {.shift = shift});
    EXPECT_TRUE(move({500, 300}));
    EXPECT_TRUE(move(to));
    release(to, button);
    EXPECT_LT(glm::distance(pixelOf(hit), to), 0.02f);
    EXPECT_EQ(camera_.yaw(), 0);
  }
}

TEST_F(NavigationTest, OnTheBackgroundThePivotIsDraggedAlong) {
  press({100, 100}, PointerButton::kMiddle);
  EXPECT_TRUE(move({130, 90}));
  EXPECT_LT(glm::distance(pixelOf({0, 0, 0}), glm::vec2(430, 290)), 0.02f);
}

TEST_F(NavigationTest, AltAndLeftOrbitsEvenWithShift) {
  press({600, 300}, PointerButton::kLeft, {.shift = true, .alt = true});
  EXPECT_TRUE(move({620, 300}));
  EXPECT_NE(camera_.yaw(), 0);
}

TEST_F(NavigationTest, ASecondButtonChangesNoDrag) {
  press({100, 100}, PointerButton::kLeft);
  press({100, 100}, PointerButton::kMiddle);
  release({100, 100}, PointerButton::kMiddle);
  EXPECT_TRUE(navigation_.isDragging());
  EXPECT_TRUE(move({120, 100}));
  EXPECT_NE(camera_.yaw(), 0);
}

TEST_F(NavigationTest, TheWheelZoomsTowardTheCursorAndPicksOnce) {
  const glm::vec2 px(600, 200);
  const glm::vec3 hit = pickAt(px)->position;
  picks_ = 0;
  for (int i = 0; i < 10; ++i)
    EXPECT_TRUE(send({.action = PointerAction::kWheel, .px = px, .wheelSteps = 0.5f}));
  EXPECT_EQ(picks_, 1);
  EXPECT_LT(glm::distance(pixelOf(hit), px), 0.05f);
  EXPECT_LT(glm::distance(camera_.eye(), hit), 5);
  move({500, 200});
  EXPECT_TRUE(send({.action = PointerAction::kWheel, .px = {500, 200}, .wheelSteps = -1}));
  EXPECT_EQ(picks_, 2);
  EXPECT_FALSE(send({.action = PointerAction::kWheel, .px = px, .wheelSteps = 0}));
}

TEST_F(NavigationTest, ADoubleClickSetsThePivotOnTheSurface) {
  const glm::vec2 px(600, 200);
  EXPECT_TRUE(send({.action = PointerAction::kDoubleClick, .px = px, .button = PointerButton::kLeft}));
  EXPECT_NEAR(camera_.pivot().y, 0.5f, 1e-5f);
  EXPECT_LT(glm::distance(pixelOf(camera_.pivot()), px), 0.02f);
  EXPECT_FALSE(
      send({.action = PointerAction::kDoubleClick, .px = {100, 200}, .button = PointerButton::kLeft}));
  EXPECT_NEAR(camera_.pivot().y, 0.5f, 1e-5f);
}

TEST_F(NavigationTest, DigitsShowTheSides) {
  EXPECT_TRUE(applyViewKey(3, false, camera_));
  EXPECT_GT(camera_.eye().x, 1);
  EXPECT_TRUE(applyViewKey(3, true, camera_));
  EXPECT_LT(camera_.eye().x, -1);
  EXPECT_TRUE(applyViewKey(7, false, camera_));
  EXPECT_GT(camera_.eye().z, 1);
  EXPECT_TRUE(applyViewKey(1, false, camera_));
  EXPECT_LT(camera_.eye().y, -1);
  EXPECT_TRUE(applyViewKey(5, false, camera_));
  EXPECT_EQ(camera_.projection(), Projection::kOrthographic);
  EXPECT_FALSE(applyViewKey(2, false, camera_));
}

TEST(AlwaysNavigates, SaysWhatNoToolTakes) {
  const auto press = [](PointerButton button, Modifiers modifiers) {
    return alwaysNavigates({.action = PointerAction::kPress, .button = button, .modifiers = modifiers});
  };
  EXPECT_TRUE(press(PointerButton::kMiddle, {}));
  EXPECT_TRUE(press(PointerButton::kRight, {}));
  EXPECT_TRUE(press(PointerButton::kLeft, {.alt = true}));
  EXPECT_FALSE(press(PointerButton::kLeft, {}));
  EXPECT_FALSE(press(PointerButton::kLeft, {.ctrl = true}));
  EXPECT_TRUE(alwaysNavigates({.action = PointerAction::kWheel, .wheelSteps = 1}));
  EXPECT_FALSE(
      alwaysNavigates({.action = PointerAction::kWheel, .modifiers = {.alt = true}, .wheelSteps = 1}));
  EXPECT_FALSE(alwaysNavigates({.action = PointerAction::kMove}));
}

}  // namespace
}  // namespace stipple
