#include "app/panels/brush_panel.h"

#include <gmock/gmock.h>

#include "tests/app/panels/overlay_picture.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

constexpr float kScales[] = {1, 2};

// A panel alone at the left upper corner.
struct Bench {
  explicit Bench(BrushModel shown, float scale = 1)
      : stage(int(260 * scale), int(420 * scale), {.scale = scale}), model(std::move(shown)) {
    place = {{8 * scale, 8 * scale}, {244 * scale, 400 * scale}, {}};
    stage.settle(draw);
  }

  // Whether some place in the panel answers to a click as asked.
  bool canClick(const std::function<bool(const BrushActions&)>& isIt) {
    return stage.clickAround(draw, [&] {
      const bool found = std::ranges::any_of(seen, isIt);
      seen.clear();
      return found;
    });
  }

  OverlayStage stage;
  BrushModel model;
  PanelPlace place;
  std::vector<BrushActions> seen = {};
  std::function<void()> draw = [this] { seen.push_back(drawBrushPanel(model, place)); };
};

TEST(BrushPanel, ChoosesEveryTool) {
  for (const float scale : kScales) {
    Bench bench(colorBrush(), scale);
    for (const PanelTool tool :
         {PanelTool::kErase, PanelTool::kSmooth, PanelTool::kSelect, PanelTool::kPaint}) {
      EXPECT_TRUE(bench.canClick([&](const BrushActions& actions) { return actions.tool == tool; }));
    }
  }
}

TEST(BrushPanel, OffersOnlyTheToolsThatThereAre) {
  BrushModel model = colorBrush();
  model.tools = {PanelTool::kPaint, PanelTool::kErase};
  Bench bench(model);
  EXPECT_FALSE(
      bench.canClick([](const BrushActions& actions) { return actions.tool == PanelTool::kSelect; }));
}

TEST(BrushPanel, ChoosesAndAddsLabels) {
  for (const float scale : kScales) {
    Bench bench(labelBrush(), scale);
    EXPECT_TRUE(bench.canClick([](const BrushActions& actions) { return actions.label == 1; }));
    EXPECT_TRUE(bench.canClick([](const BrushActions& actions) { return actions.label == 12; }));
    EXPECT_TRUE(bench.canClick([](const BrushActions& actions) { return actions.addLabel; }));
  }
}

TEST(BrushPanel, TakesARecentColor) {
  Bench bench(colorBrush());
  const Rgba8 second = std::get<PaintedColor>(bench.model.paint).recent[1];
  EXPECT_TRUE(bench.canClick([&](const BrushActions& actions) { return actions.color == second; }));
}

TEST(BrushPanel, TurnsSymmetryLimitsAndUnit) {
  using Symmetry = std::array<bool, 3>;
  for (const float scale : kScales) {
    Bench bench(labelBrush(), scale);
    EXPECT_TRUE(bench.canClick([](const BrushActions& a) {
      return a.symmetry == Symmetry{false, false, false};
    }));
    EXPECT_TRUE(bench.canClick([](const BrushActions& a) {
      return a.symmetry == Symmetry{true, false, true};
    }));
    EXPECT_TRUE(bench.canClick([](const BrushActions& a) { return a.onlyVisible == false; }));
    EXPECT_TRUE(bench.canClick([](const BrushActions& a) { return a.onlySelection == false; }));
    EXPECT_TRUE(bench.canClick([](const BrushActions& a) { return a.pressure == PanelPressure::kStrength; }));
    EXPECT_TRUE(bench.canClick([](const BrushActions& a) { return a.pressure == PanelPressure::kNone; }));
    EXPECT_TRUE(
        bench.canClick([](const BrushActions& a) { return a.radiusUnit == PanelRadiusUnit::kPixels; }));
  }
}

TEST(BrushPanel, CannotLimitItselfToNoSelection) {
  Bench bench(colorBrush());
  EXPECT_FALSE(bench.canClick([](const BrushActions& actions) { return actions.onlySelection.has_value(); }));
}

TEST(BrushPanel, APopupTakesEscapeAndTheMouse) {
  Bench bench(labelBrush());
  OverlayContext& context = bench.stage.context();
  EXPECT_TRUE(bench.stage.clickAround(bench.draw, [&] { return context.wantsKeyboard(); }));
  context.moveMouse({255, 415});
  EXPECT_TRUE(context.wantsMouse()) << "a click beside it only closes it";
  context.setKey(OverlayKey::kEscape, true);
  bench.stage.settle(bench.draw);
  EXPECT_FALSE(context.wantsKeyboard());
  EXPECT_FALSE(context.wantsMouse());
}

TEST(BrushPanel, DragsNumbersWithinTheirRange) {
  BrushModel model = maskBrush();
  model.strength = 0.5f;
  Bench bench(model);
  // Applied as a window does it, each frame.
  std::vector<float> strengths;
  const auto draw = [&] {
    const BrushActions actions = drawBrushPanel(bench.model, bench.place);
    if (actions.strength) strengths.push_back(bench.model.strength = *actions.strength);
  };
  // The field that answers to a drag with its strength, wherever it stands.
  for (float y = 110; strengths.empty() && y < 400; y += 8) bench.stage.drag({120, y}, {160, y}, draw);
  ASSERT_FALSE(strengths.empty());
  EXPECT_NEAR(strengths.back(), 0.5 + 40.0 / 220, 0.04) << "a field's width is its range";
}

TEST(BrushPanel, TypesNumbers) {
  Bench bench(maskBrush());
  OverlayContext& context = bench.stage.context();
  bool isTyped = false;
  for (float y = 110; !isTyped && y < 400; y += 8) {
    context.setModifiers({.ctrl = true});
    bench.stage.click({120, y}, bench.draw);
    context.setModifiers({});
    bench.stage.frame(bench.draw);
    if (!context.wantsKeyboard()) continue;
    bench.seen.clear();
    for (const char32_t digit : std::u32string(U"77")) context.typeCharacter(digit);
    context.setKey(OverlayKey::kEnter, true);
    bench.stage.settle(bench.draw);
    context.setKey(OverlayKey::kEnter, false);
    isTyped =
        std::ranges::any_of(bench.seen, [](const BrushActions& actions) { return actions.radius == 77.0f; });
  }
  EXPECT_TRUE(isTyped);
}

TEST(BrushPanel, IsQuietWithoutInput) {
  Bench bench(labelBrush());
  bench.seen.clear();
  bench.stage.settle(bench.draw);
  for (const BrushActions& actions : bench.seen) {
    EXPECT_FALSE(actions.tool || actions.attribute || actions.label || actions.addLabel || actions.radius ||
                 actions.strength || actions.spacing || actions.radiusUnit || actions.symmetry ||
                 actions.onlyVisible || actions.onlySelection || actions.pressure);
  }
}

}  // namespace
}  // namespace stipple
