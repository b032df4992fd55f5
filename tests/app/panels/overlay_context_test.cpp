#include "app/panels/overlay_context.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <string>

#include "tests/app/panels/overlay_picture.h"

namespace stipple {
namespace {

// A window at (10, 10) with one button, whose presses are counted.
struct Counter {
  int clicks = 0;

  void draw() {
    ImGui::SetNextWindowPos(ImVec2(10, 10));
    ImGui::SetNextWindowSize(ImVec2(120, 80));
    ImGui::Begin("counter", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize);
    if (ImGui::Button("press", ImVec2(80, 40))) ++clicks;
    ImGui::End();
  }
};

constexpr glm::vec2 kOnButton{40, 40}, kBeside{180, 140};

TEST(OverlayContext, SeesAClickShorterThanAFrame) {
  OverlayStage stage(200, 160);
  Counter counter;
  const auto draw = [&] { counter.draw(); };
  stage.settle(draw);
  OverlayContext& context = stage.context();
  context.moveMouse(kOnButton);
  stage.frame(draw);
  EXPECT_FALSE(context.hasPendingInput());
  context.setButton(OverlayButton::kLeft, true);
  context.setButton(OverlayButton::kLeft, false);
  EXPECT_TRUE(context.hasPendingInput());
  stage.frame(draw);
  EXPECT_TRUE(context.hasPendingInput()) << "the release is still to be shown";
  stage.frame(draw);
  EXPECT_EQ(counter.clicks, 1);
  EXPECT_FALSE(context.hasPendingInput());
}

TEST(OverlayContext, APanelOfItsOwnSizeAsksForTheFrameThatShowsIt) {
  OverlayStage stage(200, 160);
  const auto draw = [] {
    ImGui::Begin("fitting", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::TextUnformatted("as large as this");
    ImGui::End();
  };
  stage.settle([] {});
  EXPECT_FALSE(stage.context().hasHiddenPanels());
  stage.frame(draw);
  EXPECT_TRUE(stage.context().hasHiddenPanels());
  for (int i = 0; i < 3; ++i) stage.frame(draw);
  EXPECT_FALSE(stage.context().hasHiddenPanels());
}

TEST(OverlayContext, WantsTheMouseOverAPanelAtOnce) {
  OverlayStage stage(200, 160);
  Counter counter;
  stage.settle([&] { counter.draw(); });
  OverlayContext& context = stage.context();
  context.moveMouse(kOnButton);
  EXPECT_TRUE(context.wantsMouse()) << "no frame in between";
  context.moveMouse(kBeside);
  EXPECT_FALSE(context.wantsMouse());
  context.leaveMouse();
  EXPECT_FALSE(context.wantsMouse());
}

TEST(OverlayContext, ADragStaysWithWhomItBegan) {
  OverlayStage stage(200, 160);
  Counter counter;
  const auto draw = [&] { counter.draw(); };
  stage.settle(draw);
  OverlayContext& context = stage.context();
  for (const bool beginsOnPanel : {false, true}) {
    context.moveMouse(beginsOnPanel ? kOnButton : kBeside);
    context.setButton(OverlayButton::kLeft, true);
    stage.frame(draw);
    context.moveMouse(beginsOnPanel ? kBeside : kOnButton);
    stage.frame(draw);
    EXPECT_EQ(context.wantsMouse(), beginsOnPanel);
    context.setButton(OverlayButton::kLeft, false);
    EXPECT_EQ(context.wantsMouse(), !beginsOnPanel);
    stage.frame(draw);
  }
  EXPECT_EQ(counter.clicks, 0);
}

TEST(OverlayContext, TypesIntoFields) {
  OverlayStage stage(200, 160);
  char text[32] = "";
  const auto draw = [&] {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(180, 80));
    ImGui::Begin("field", nullptr, ImGuiWindowFlags_NoTitleBar);
    ImGui::InputText("##text", text, sizeof(text));
    ImGui::End();
  };
  stage.settle(draw);
  OverlayContext& context = stage.context();
  EXPECT_FALSE(context.wantsKeyboard());
  stage.click({40, 20}, draw);
  EXPECT_TRUE(context.wantsKeyboard());
  for (const char32_t character : std::u32string(U"h\u00e4 \u03c4")) context.typeCharacter(character);
  stage.frame(draw);
  EXPECT_STREQ(text, "h\u00e4 \u03c4");
  context.setKey(OverlayKey::kBackspace, true);
  context.setKey(OverlayKey::kBackspace, false);
  stage.frame(draw);
  EXPECT_STREQ(text, "h\u00e4 ");
  EXPECT_EQ(context.cursor(), OverlayCursor::kText);
}

TEST(OverlayContext, SeveralLiveSideBySide) {
  OverlayStage first(200, 160), second(200, 160, {.scale = 2});
  Counter one, two;
  first.settle([&] { one.draw(); });
  second.settle([&] { two.draw(); });
  first.click(kOnButton, [&] { one.draw(); });
  EXPECT_EQ(one.clicks, 1);
  EXPECT_EQ(two.clicks, 0);
  EXPECT_FALSE(second.context().wantsMouse());
  OverlayContext moved = std::move(second.context());
  moved.moveMouse(kOnButton);
  EXPECT_TRUE(moved.wantsMouse());
  EXPECT_EQ(moved.look().scale, 2);
}

TEST(OverlayContext, AnotherScaleIsAnotherAtlas) {
  OverlayContext context;
  const std::uint64_t revision = context.atlasRevision();
  const int height = context.atlas().height;
  context.setLook({.scale = 1, .theme = OverlayTheme::kLight});
  EXPECT_EQ(context.atlasRevision(), revision);
  context.setLook({.scale = 2, .theme = OverlayTheme::kLight});
  EXPECT_GT(context.atlasRevision(), revision);
  EXPECT_GT(context.atlas().height * context.atlas().width, height * 512);
  context.beginFrame({100, 100}, 0);
  context.endFrame();
}

}  // namespace
}  // namespace stipple
