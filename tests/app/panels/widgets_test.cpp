#include "app/panels/widgets.h"

#include <gtest/gtest.h>

#include "app/panels/panel_window.h"
#include "tests/app/panels/overlay_picture.h"

namespace stipple {
namespace {

constexpr PanelPlace kPlace{{0, 0}, {220, 100}, {}};
constexpr glm::vec2 kOnField{60, 20};

// One field from 1 to 100 whose value is applied each frame.
struct Field {
  explicit Field(bool isLogarithmic) {
    field = {.label = "Radius", .value = 10, .min = 1, .max = 100, .isLogarithmic = isLogarithmic};
    stage.settle(draw);
  }

  OverlayStage stage{240, 120};
  ValueField field;
  std::function<void()> draw = [this] {
    const PanelWindow window("panel", kPlace);
    if (const auto value = valueField(field)) field.value = *value;
  };
};

TEST(ValueField, ADragOverItsWidthIsItsRange) {
  Field field(false);
  const float width = 220 - 2 * 12;
  field.stage.drag(kOnField, kOnField + glm::vec2(width / 2, 0), field.draw);
  EXPECT_NEAR(field.field.value, 10 + 99.0f / 2, 3);
  Field other(false);
  other.stage.drag(kOnField, kOnField - glm::vec2(2 * width, 0), other.draw);
  EXPECT_EQ(other.field.value, 1) << "and not below";
}

TEST(ValueField, LogarithmicMultipliesByTheSameEverywhere) {
  Field field(true);
  const float width = 220 - 2 * 12;
  field.stage.drag(kOnField, kOnField + glm::vec2(width / 4, 0), field.draw);
  EXPECT_NEAR(field.field.value, 10 * std::sqrt(10.0f), 2);
}

TEST(ValueField, ShiftDragsFinely) {
  Field field(false);
  field.stage.context().setModifiers({.shift = true});
  field.stage.drag(kOnField, kOnField + glm::vec2(98, 0), field.draw);
  EXPECT_NEAR(field.field.value, 10 + 99.0f / 20, 0.5);
}

TEST(ValueField, AClickAloneChangesNothing) {
  Field field(false);
  field.stage.click(kOnField + glm::vec2(100, 0), field.draw);
  EXPECT_EQ(field.field.value, 10);
}

TEST(ValueField, ADoubleClickTypes) {
  Field field(false);
  field.stage.click(kOnField, field.draw);
  field.stage.click(kOnField, field.draw);
  OverlayContext& context = field.stage.context();
  ASSERT_TRUE(context.wantsKeyboard());
  for (const char32_t character : std::u32string(U"250")) context.typeCharacter(character);
  context.setKey(OverlayKey::kEnter, true);
  field.stage.settle(field.draw);
  EXPECT_EQ(field.field.value, 100) << "within the range";
  EXPECT_FALSE(context.wantsKeyboard());
}

TEST(Button, ThatIsDisabledIsNotClicked) {
  for (const bool isEnabled : {true, false}) {
    OverlayStage stage(240, 120);
    int clicks = 0;
    const auto draw = [&] {
      const PanelWindow window("panel", kPlace);
      clicks += textButton("Go", {.isEnabled = isEnabled});
    };
    stage.settle(draw);
    stage.click({20, 20}, draw);
    EXPECT_EQ(clicks, isEnabled ? 1 : 0);
  }
}

TEST(Help, AppearsOverItsItemAfterAWhile) {
  OverlayStage stage(300, 120);
  const auto draw = [&] {
    const PanelWindow window("panel", kPlace);
    textButton("Go", {.help = "What it does, in a sentence that is long enough to be wrapped somewhere."});
  };
  stage.settle(draw);
  stage.context().moveMouse({20, 20});
  stage.settle(draw);
  const Image before = stage.picture();
  for (int i = 0; i < 40; ++i) stage.frame(draw);
  EXPECT_NE(stage.picture().pixels, before.pixels);
  stage.save("help");
}

}  // namespace
}  // namespace stipple
