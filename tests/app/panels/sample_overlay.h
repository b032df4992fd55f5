#pragma once

#include "app/panels/overlay.h"

namespace stipple {

/// Panels as they are in the midst of work.
BrushModel colorBrush();
BrushModel labelBrush();
BrushModel maskBrush();
CurveModel residualCurve();
StatisticsModel busyStatistics();
LegendModel curvatureLegend();
LegendModel segmentLegend();
std::vector<HintCard> firstCards();
MessageModel failure();

/// All panels at once, with as much in them as they are made for.
OverlayModel fullOverlay();

}  // namespace stipple
