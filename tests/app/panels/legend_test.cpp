#include "app/panels/legend.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/app/panels/overlay_picture.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

constexpr PanelPlace kPlace{{10, 10}, {140, 300}, {}};

bool has(const Image& image, const Rgba8& color) {
  return std::ranges::find(image.pixels, color) != image.pixels.end();
}

TEST(Legend, ShowsTheColormapFromEndToEnd) {
  for (const Colormap map : {Colormap::kViridis, Colormap::kTurbo, Colormap::kBlueToRed, Colormap::kGray}) {
    OverlayStage stage(160, 320);
    LegendModel model = curvatureLegend();
    std::get<ScalarLegend>(model.content).colormap = map;
    stage.settle([&] { drawLegend(model, kPlace); });
    const Image image = stage.picture();
    // Each row of the bar is as high as a pixel: the middle of the first, the middle one, and the last.
    constexpr int kRows = 150;
    for (const int row : {0, 75, 149}) EXPECT_TRUE(has(image, mapColor(map, (row + 0.5) / kRows))) << row;
  }
}

TEST(Legend, ShowsRangesOfEveryKind) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  OverlayStage stage(160, 320);
  for (const auto& [low, high] :
       {std::pair(0.0, 0.0), {1e-30, 1e30}, {3, 2}, {-kInfinity, 5}, {0, std::nan("")}}) {
    const LegendModel model{.attribute = "", .content = ScalarLegend{.low = low, .high = high}};
    stage.settle([&] { drawLegend(model, kPlace); });
  }
}

TEST(Legend, LabelsAreClicked) {
  for (const std::int64_t label : {0, 7}) {
    OverlayStage stage(160, 320);
    std::optional<std::int64_t> clicked;
    const auto draw = [&] {
      if (const auto action = drawLegend(segmentLegend(), kPlace).label) clicked = action;
    };
    stage.settle(draw);
    EXPECT_TRUE(stage.clickAround(draw, [&] { return clicked == label; }));
    EXPECT_TRUE(has(stage.picture(), labelColor(label)));
  }
}

}  // namespace
}  // namespace stipple
