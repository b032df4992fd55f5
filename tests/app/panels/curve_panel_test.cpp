#include "app/panels/curve_panel.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/app/panels/overlay_picture.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

bool canClick(const CurveModel& model, bool CurveActions::*action, float scale = 1) {
  OverlayStage stage(int(260 * scale), int(240 * scale), {.scale = scale});
  const PanelPlace place{{8 * scale, 8 * scale}, {244 * scale, 224 * scale}, {}};
  bool wasSeen = false;
  const auto draw = [&] { wasSeen |= drawCurvePanel(model, place).*action; };
  stage.settle(draw);
  return stage.clickAround(draw, [&] { return wasSeen; });
}

TEST(CurvePanel, ARunningProcessIsPausedSteppedStoppedAndCanceled) {
  const CurveModel model = residualCurve();
  for (const float scale : {1.0f, 2.0f}) {
    EXPECT_TRUE(canClick(model, &CurveActions::pause, scale));
    EXPECT_TRUE(canClick(model, &CurveActions::step, scale));
    EXPECT_TRUE(canClick(model, &CurveActions::stop, scale));
    EXPECT_TRUE(canClick(model, &CurveActions::cancel, scale));
    EXPECT_FALSE(canClick(model, &CurveActions::resume, scale));
  }
}

TEST(CurvePanel, APausedProcessGoesOn) {
  CurveModel model = residualCurve();
  model.state = ProcessPhase::kPaused;
  EXPECT_TRUE(canClick(model, &CurveActions::resume));
  EXPECT_FALSE(canClick(model, &CurveActions::pause));
}

TEST(CurvePanel, WhatCannotBePausedCanBeCanceled) {
  CurveModel model = residualCurve();
  model.canBePaused = false;
  EXPECT_FALSE(canClick(model, &CurveActions::pause));
  EXPECT_FALSE(canClick(model, &CurveActions::step));
  EXPECT_TRUE(canClick(model, &CurveActions::cancel));
}

TEST(CurvePanel, AFinishedProcessIsClosed) {
  CurveModel model = residualCurve();
  model.state = ProcessPhase::kFinished;
  EXPECT_TRUE(canClick(model, &CurveActions::close));
  EXPECT_FALSE(canClick(model, &CurveActions::cancel));
  EXPECT_FALSE(canClick(model, &CurveActions::stop));
}

TEST(CurvePanel, DrawsCurvesOfEveryLengthAndKind) {
  OverlayStage stage(260, 240);
  const PanelPlace place{{8, 8}, {244, 224}, {}};
  CurveModel model{.process = "Fairing with a rather long name for a panel", .quantity = "change per step"};
  for (const std::size_t length : {0, 1, 2, 100'000}) {
    for (const double first : {0.0, 1e-300, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
      model.values.assign(length, 1.0);
      if (length > 0) model.values.front() = first;
      stage.settle([&] { drawCurvePanel(model, place); });
    }
  }
}

}  // namespace
}  // namespace stipple
