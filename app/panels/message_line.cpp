#include "app/panels/message_line.h"

#include <algorithm>

#include "app/panels/theme.h"
#include "app/panels/widgets.h"

namespace stipple {

namespace {

constexpr float kNoteSeconds = 6, kFadeSeconds = 0.6f;

// Opacity stays above nothing while the message lives, so that the mouse can still hold it.
constexpr float kLeastOpacity = 0.02f;

}  // namespace

float opacityOf(const MessageModel& model) {
  if (model.kind == MessageKind::kError) return 1;
  return std::clamp((kNoteSeconds - model.ageSeconds) / kFadeSeconds, 0.0f, 1.0f);
}

MessageActions drawMessageLine(const MessageModel& model, const PanelPlace& place) {
  MessageActions actions;
  const bool isHeld = ImGui::IsMouseHoveringRect(
      ImVec2(place.position.x, place.position.y),
      ImVec2(place.position.x + place.size.x, place.position.y + place.size.y), false);
  const float opacity = isHeld ? 1 : opacityOf(model);
  if (opacity <= 0) return {.dismiss = true};
  const PanelWindow window("message", place,
                           {.fillsWidth = false, .opacity = std::max(opacity, kLeastOpacity)});
  const bool isError = model.kind == MessageKind::kError;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), side = scaled(15), gap = scaled(10);
  drawIcon(*ImGui::GetWindowDrawList(), isError ? Icon::kWarning : Icon::kNote,
           ImVec2(from.x + side / 2, from.y + height / 2), side,
           isError ? accentInk() : ImGui::GetColorU32(ImGuiCol_TextDisabled));
  ImGui::Dummy(ImVec2(side, height));
  ImGui::SameLine(0, gap);
  const float others = (model.hasDetails ? ImGui::CalcTextSize("details").x + gap : 0) + height + gap;
  const float padding = 2 * ImGui::GetStyle().WindowPadding.x;
  shortenedText(model.text, {.width = place.size.x - padding - side - gap - others, .height = height});
  if (model.hasDetails) {
    ImGui::SameLine(0, gap);
    actions.showDetails = link("details");
  }
  ImGui::SameLine(0, gap);
  actions.dismiss = iconButton("##dismiss", Icon::kClose, {.size = ImVec2(height, height)});
  return actions;
}

}  // namespace stipple
