#include "tests/app/panels/sample_overlay.h"

#include <cmath>

namespace stipple {

BrushModel colorBrush() {
  BrushModel brush;
  brush.attributes = {"color", "segment", "defect mask"};
  brush.paint = PaintedColor{.color = {196, 94, 64, 255},
                             .recent = {{196, 94, 64, 255},
                                        {240, 226, 200, 255},
                                        {52, 84, 120, 255},
                                        {30, 30, 30, 255},
                                        {120, 160, 80, 255},
                                        {250, 250, 250, 255}}};
  brush.radius = 34;
  brush.strength = 0.8f;
  return brush;
}

BrushModel labelBrush() {
  BrushModel brush = colorBrush();
  brush.attribute = 1;
  brush.paint = PaintedLabel{.label = 3, .labels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
  brush.radiusUnit = PanelRadiusUnit::kModel;
  brush.radius = 0.0125f;
  brush.minRadius = 1e-4f;
  brush.maxRadius = 0.5f;
  brush.symmetry = {true, false, false};
  brush.hasSelection = true;
  brush.onlySelection = true;
  return brush;
}

BrushModel maskBrush() {
  BrushModel brush = colorBrush();
  brush.attribute = 2;
  brush.tool = PanelTool::kErase;
  brush.paint = PaintedNumber{.value = 0.75f};
  return brush;
}

CurveModel residualCurve() {
  CurveModel curve{.process = "Segmentation", .quantity = "residual"};
  for (int i = 0; i < 180; ++i)
    curve.values.push_back(2.5 * std::exp(-0.05 * i) * (1 + 0.2 * std::sin(0.7 * i)));
  curve.steps = 180;
  curve.fraction = 0.62;
  curve.secondsLeft = 3.2;
  return curve;
}

StatisticsModel busyStatistics() {
  StatisticsModel statistics{.points = 1'134'345, .splats = 212'400, .tau = 3, .backEnd = "processor"};
  for (int i = 0; i < 120; ++i) {
    statistics.frameMilliseconds.push_back(9 + 3 * std::sin(0.21f * i) + (i % 37 == 5 ? 29.0f : 0.0f));
  }
  return statistics;
}

LegendModel curvatureLegend() {
  return {.attribute = "mean curvature",
          .content = ScalarLegend{
              .colormap = Colormap::kBlueToRed, .low = -12.4, .high = 17.9, .unit = "1 / length"}};
}

LegendModel segmentLegend() {
  LabelLegend legend;
  for (int label = 0; label < 8; ++label) legend.labels.push_back({label, 134'345 / (label * label + 1)});
  return {.attribute = "segment", .content = legend};
}

std::vector<HintCard> firstCards() {
  return {{"segment", "Paint seeds and segment",
           "Mark a few parts with the brush and watch the segments grow to the creases."},
          {"zebra", "Grow a zebra", "Let a reaction and a diffusion draw stripes over the whole surface."},
          {"repair", "Repair a scar", "Paint over a damaged place and let the surface close it smoothly."}};
}

MessageModel failure() {
  return {.text = "fairing stopped: radius[17] is \u22120.2, expected > 0",
          .kind = MessageKind::kError,
          .hasDetails = true};
}

OverlayModel fullOverlay() {
  return {.brush = labelBrush(),
          .curve = residualCurve(),
          .statistics = busyStatistics(),
          .legend = curvatureLegend(),
          .cards = firstCards(),
          .message = failure()};
}

}  // namespace stipple
