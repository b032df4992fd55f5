#pragma once

#include <optional>
#include <vector>

#include "app/panels/brush_panel.h"
#include "app/panels/curve_panel.h"
#include "app/panels/hint_cards.h"
#include "app/panels/legend.h"
#include "app/panels/message_line.h"
#include "app/panels/statistics_panel.h"

namespace stipple {

/// All that the overlay shows; what is absent is hidden.
struct OverlayModel {
  std::optional<BrushModel> brush = {};
  std::optional<CurveModel> curve = {};
  std::optional<StatisticsModel> statistics = {};
  std::optional<LegendModel> legend = {};
  std::vector<HintCard> cards = {};
  std::optional<MessageModel> message = {};
};

struct OverlayActions {
  BrushActions brush;
  CurveActions curve;
  LegendActions legend;
  HintActions cards;
  MessageActions message;
};

/// Between a context's beginFrame and endFrame: lays the panels out in its view and draws them.
OverlayActions drawOverlay(const OverlayModel& model);

}  // namespace stipple
