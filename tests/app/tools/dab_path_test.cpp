#include "app/tools/dab_path.h"

#include <gtest/gtest.h>

#include "tests/app/tools/pick_scene.h"

namespace stipple {
namespace {

std::vector<PathDab> draw(const PickScene& scene, const DabPathOptions& options,
                          const std::vector<glm::vec2>& way, float pressureAtEnd = 1) {
  DabPath path(options, way[0], *scene.pickAt(way[0]), 1);
  std::vector<PathDab> dabs;
  for (std::size_t w = 1; w < way.size(); ++w) {
    const float t = static_cast<float>(w) / static_cast<float>(way.size() - 1);
    const auto more = path.extendTo(way[w], 1 + t * (pressureAtEnd - 1), scene.view, scene.picker());
    dabs.insert(dabs.end(), more.begin(), more.end());
  }
  return dabs;
}

std::vector<glm::vec2> wayOf(const glm::vec2& from, const glm::vec2& to, int events) {
  std::vector<glm::vec2> way;
  for (int e = 0; e <= events; ++e)
    way.push_back(from + static_cast<float>(e) / static_cast<float>(events) * (to - from));
  return way;
}

TEST(DabPath, LaysDabsEvenlyHoweverManyEventsThereAre) {
  const PickScene scene;
  const DabPathOptions options{.radius = 0.2f, .spacing = 0.25f};
  const glm::vec2 from(100, 300), to(700, 420);
  const float length = glm::distance(scene.pickAt(from)->position, scene.pickAt(to)->position);
  for (const int events : {1, 7, 100, 600}) {
    const auto dabs = draw(scene, options, wayOf(from, to, events));
    EXPECT_NEAR(static_cast<float>(dabs.size()), length / 0.05f, 1.5f) << events << " events";
    glm::vec3 last = scene.pickAt(from)->position;
    for (const PathDab& dab : dabs) {
      EXPECT_NEAR(glm::distance(dab.position, last), 0.05f, 1.5f * scene.pixel()) << events << " events";
      EXPECT_TRUE(scene.isOnAStrip(dab.position));
      last = dab.position;
    }
  }
}

TEST(DabPath, MeasuresAlongTheSurfaceAndNotThePicture) {
  PickScene scene;
  scene.strips = {{.slope = -2}};  // 63 degrees
  const auto dabs = draw(scene, {.radius = 0.4f, .spacing = 0.25f}, wayOf({300, 300}, {500, 300}, 5));
  ASSERT_GT(dabs.size(), 5u);
  for (std::size_t d = 1; d < dabs.size(); ++d)
    EXPECT_NEAR(glm::distance(dabs[d].position, dabs[d - 1].position), 0.1f, 4 * scene.pixel());
}

TEST(DabPath, LaysNothingAcrossAHole) {
  PickScene scene;
  scene.strips = {{.right = -0.3f}, {.left = 0.3f}};
  for (const int events : {1, 3, 50}) {
    const auto dabs = draw(scene, {.radius = 0.2f}, wayOf({100, 300}, {700, 300}, events));
    int before = 0, behind = 0;
    for (const PathDab& dab : dabs) {
      EXPECT_TRUE(scene.isOnAStrip(dab.position)) << dab.position.x;
      ++(dab.position.x < 0 ? before : behind);
    }
    EXPECT_GT(before, 15);
    EXPECT_GT(behind, 15);
    // The far rim is touched at once.
    float first = 1;
    for (const PathDab& dab : dabs)
      if (dab.position.x > 0) first = std::min(first, dab.position.x);
    EXPECT_NEAR(first, 0.3f, 6 * scene.pixel());
  }
}

TEST(DabPath, LaysNothingBetweenPartsOfDifferentDepth) {
  PickScene scene;
  scene.strips = {{.height = 1.5f, .right = 0}, {.height = 0}};
  for (const int events : {1, 40}) {
    const auto dabs = draw(scene, {.radius = 0.2f}, wayOf({200, 300}, {600, 300}, events));
    int near = 0, far = 0;
    for (const PathDab& dab : dabs) {
      EXPECT_TRUE(scene.isOnAStrip(dab.position)) << dab.position.z;
      ++(dab.position.z > 1 ? near : far);
    }
    EXPECT_GT(near, 5);
    EXPECT_GT(far, 5);
  }
}

TEST(DabPath, KeepsItsSpacingAlongARim) {
  PickScene scene;
  scene.strips = {{.right = 0.5f * scene.pixel()}};
  // To and fro over the rim, pixel by pixel.
  std::vector<glm::vec2> way;
  for (int i = 0; i < 200; ++i) way.emplace_back(i % 2 == 0 ? 399 : 403, 200 + i / 2);
  const auto dabs = draw(scene, {.radius = 0.2f, .spacing = 0.5f}, way);
  EXPECT_LE(dabs.size(), 100 * scene.pixel() / 0.1f + 1);
}

TEST(DabPath, IsNoFinerThanThePixels) {
  const PickScene scene;
  const auto dabs = draw(scene, {.radius = 1e-5f, .spacing = 0.1f}, wayOf({100, 300}, {700, 300}, 3));
  EXPECT_LE(dabs.size(), 601u);
  EXPECT_GE(dabs.size(), 500u);
}

TEST(DabPath, PicksLittle) {
  const PickScene scene;
  const auto dabs = draw(scene, {.radius = 100 * scene.pixel()}, wayOf({100, 300}, {700, 300}, 1));
  EXPECT_LE(scene.picks, 5 * static_cast<int>(dabs.size()) + 5);
}

TEST(DabPath, PressureChangesEvenlyAndMayScaleTheSpacing) {
  const PickScene scene;
  const auto way = wayOf({100, 300}, {700, 300}, 3);
  const auto even = draw(scene, {.radius = 0.2f}, way, 0.2f);
  for (std::size_t d = 1; d < even.size(); ++d) EXPECT_LT(even[d].pressure, even[d - 1].pressure);
  EXPECT_NEAR(even.back().pressure, 0.2f, 0.05f);
  const auto scaled = draw(scene, {.radius = 0.2f, .pressureScalesRadius = true}, way, 0.2f);
  for (std::size_t d = 1; d < scaled.size(); ++d) {
    const float step = glm::distance(scaled[d].position, scaled[d - 1].position);
    EXPECT_NEAR(step, 0.05f * scaled[d].pressure, 3 * scene.pixel());
  }
}

TEST(DabPath, GoesOnWhereThePointerComesBack) {
  PickScene scene;
  scene.strips = {{.right = 0}};
  DabPath path({.radius = 0.2f}, {200, 300}, *scene.pickAt({200, 300}), 1);
  EXPECT_FALSE(path.extendTo({390, 300}, 1, scene.view, scene.picker()).empty());
  const glm::vec3 last = path.lastPlace();
  EXPECT_LE(path.extendTo({700, 300}, 1, scene.view, scene.picker()).size(), 1u);
  EXPECT_TRUE(path.extendTo({700, 500}, 1, scene.view, scene.picker()).empty());
  EXPECT_NEAR(path.lastPlace().x, last.x, 0.1f);
  EXPECT_FALSE(path.extendTo({200, 500}, 1, scene.view, scene.picker()).empty());
}

}  // namespace
}  // namespace stipple
