#include "app/panels/overlay.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <fmt/format.h>

#include "tests/app/panels/overlay_picture.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

struct Screen {
  const char* name;
  int width, height;
  float scale;
};
constexpr Screen kScreens[] = {{"1280x800", 1280, 800, 1},
                               {"2560x1440_scale_2", 2560, 1440, 2},
                               {"1500x1050_scale_1.5", 1500, 1050, 1.5f},
                               {"940x700", 940, 700, 1}};

TEST(Overlay, NothingIsClippedOrOverlaps) {
  for (const Screen& screen : kScreens) {
    SCOPED_TRACE(screen.name);
    OverlayStage stage(screen.width, screen.height, {.scale = screen.scale});
    const OverlayModel model = fullOverlay();
    stage.settle([&] { drawOverlay(model); });
    stage.save(fmt::format("overlay_{}", screen.name));
    std::vector<ImRect> panels;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      if (!window->Active || window->Hidden || std::string_view(window->Name).starts_with("Debug")) continue;
      SCOPED_TRACE(window->Name);
      const ImRect panel = window->Rect();
      EXPECT_TRUE(ImRect(0, 0, float(screen.width), float(screen.height)).Contains(panel));
      EXPECT_LE(window->ScrollMax.y, 0);
      EXPECT_LE(window->ScrollMax.x, 0);
      EXPECT_LE(window->ContentSize.x, window->InnerRect.GetWidth());
      for (const ImRect& other : panels) EXPECT_FALSE(panel.Overlaps(other));
      panels.push_back(panel);
    }
    EXPECT_EQ(panels.size(), 8u);
  }
}

TEST(Overlay, SurvivesEverySizeOfView) {
  OverlayStage stage(1, 1);
  const OverlayModel model = fullOverlay();
  OverlayContext& context = stage.context();
  for (const glm::ivec2 size : {glm::ivec2(0, 0), {1, 1}, {90, 2000}, {2000, 60}, {300, 300}, {600, 500}}) {
    for (int i = 0; i < 3; ++i) {
      context.beginFrame(size, 0.016f);
      drawOverlay(model);
      context.endFrame();
    }
  }
}

TEST(Overlay, WhatIsHiddenIsNotDrawn) {
  OverlayStage stage(800, 600);
  const Image empty = (stage.settle([] { drawOverlay({}); }), stage.picture());
  OverlayModel model;
  model.statistics = busyStatistics();
  stage.settle([&] { drawOverlay(model); });
  EXPECT_NE(stage.picture().pixels, empty.pixels);
  stage.settle([] { drawOverlay({}); });
  EXPECT_EQ(stage.picture().pixels, empty.pixels);
}

// Pictures of panels in other states, for people to look at.
TEST(Overlay, HasManyFaces) {
  for (const float scale : {1.0f, 2.0f}) {
    for (const OverlayTheme theme : {OverlayTheme::kDark, OverlayTheme::kLight}) {
      OverlayStage stage(int(1000 * scale), int(640 * scale), {.scale = scale, .theme = theme});
      const std::string end = fmt::format("{}_{}", theme == OverlayTheme::kDark ? "dark" : "light", scale);
      OverlayModel model = fullOverlay();
      model.brush = colorBrush();
      model.legend = segmentLegend();
      model.curve->state = ProcessPhase::kPaused;
      model.cards.clear();
      stage.settle([&] { drawOverlay(model); });
      stage.click(glm::vec2(130, 130) * scale, [&] { drawOverlay(model); });
      stage.save("color_" + end);

      model.brush = maskBrush();
      model.curve->state = ProcessPhase::kFinished;
      model.curve->quantity.clear();
      model.message = MessageModel{.text = "saved bunny.ply, 134,345 points"};
      stage.context().setKey(OverlayKey::kEscape, true);
      stage.settle([&] { drawOverlay(model); });
      stage.click(glm::vec2(130, 92) * scale, [&] { drawOverlay(model); });
      stage.save("mask_" + end);
    }
  }
}

}  // namespace
}  // namespace stipple
