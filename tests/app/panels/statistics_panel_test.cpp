#include "app/panels/statistics_panel.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/app/panels/overlay_picture.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

constexpr PanelPlace kPlace{{8, 8}, {196, 172}, {}};

int pixelsOf(const Image& image, const Rgba8& color) {
  return static_cast<int>(std::ranges::count(image.pixels, color));
}

TEST(StatisticsPanel, MarksFramesThatStutter) {
  constexpr Rgba8 kAccent{255, 152, 26, 255};
  OverlayStage stage(212, 188);
  StatisticsModel model = busyStatistics();
  model.frameMilliseconds.assign(20, 9.0f);
  stage.settle([&] { drawStatisticsPanel(model, kPlace); });
  EXPECT_EQ(pixelsOf(stage.picture(), kAccent), 0);
  model.frameMilliseconds[10] = 50;
  stage.settle([&] { drawStatisticsPanel(model, kPlace); });
  EXPECT_EQ(pixelsOf(stage.picture(), kAccent), 2 * 29) << "one bar, two pixels wide, crossed by a line";
}

TEST(StatisticsPanel, ShowsTimesOfEveryLengthAndKind) {
  OverlayStage stage(212, 188);
  StatisticsModel model = busyStatistics();
  for (const float time : {0.0f, -1.0f, 1e30f, std::numeric_limits<float>::quiet_NaN()}) {
    model.frameMilliseconds.assign(1000, time);
    stage.settle([&] { drawStatisticsPanel(model, kPlace); });
  }
  model.frameMilliseconds.clear();
  stage.settle([&] { drawStatisticsPanel(model, kPlace); });
}

}  // namespace
}  // namespace stipple
