#include "app/panels/overlay.h"

#include <imgui.h>

#include "app/panels/overlay_layout.h"
#include "app/panels/theme.h"

namespace stipple {

OverlayActions drawOverlay(const OverlayModel& model) {
  const ImVec2 view = ImGui::GetIO().DisplaySize;
  const OverlayLayout layout = layOut({view.x, view.y}, overlayScale(),
                                      {.brush = model.brush.has_value(),
                                       .curve = model.curve.has_value(),
                                       .statistics = model.statistics.has_value(),
                                       .legend = model.legend.has_value(),
                                       .message = model.message.has_value(),
                                       .cards = model.cards.size()});
  OverlayActions actions;
  if (model.brush) actions.brush = drawBrushPanel(*model.brush, layout.brush);
  if (model.curve) actions.curve = drawCurvePanel(*model.curve, layout.curve);
  if (model.statistics) drawStatisticsPanel(*model.statistics, layout.statistics);
  if (model.legend) actions.legend = drawLegend(*model.legend, layout.legend);
  actions.cards = drawHintCards(model.cards, layout.cards);
  if (model.message) actions.message = drawMessageLine(*model.message, layout.message);
  return actions;
}

}  // namespace stipple
