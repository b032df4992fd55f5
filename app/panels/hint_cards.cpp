#include "app/panels/hint_cards.h"

#include <algorithm>

#include "app/panels/theme.h"
#include "app/panels/widgets.h"

namespace stipple {

namespace {

void drawCard(const HintCard& card, const PanelPlace& place, HintActions& actions) {
  const PanelWindow window(("hint " + card.id).c_str(), place);
  title(card.title);
  // The sentence wraps; the buttons stand at the card's lower edge, so that cards of one row are alike.
  ImGui::PushFont(smallFont());
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", card.sentence.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  const float bottom = place.size.y - ImGui::GetStyle().WindowPadding.y - ImGui::GetFrameHeight();
  if (ImGui::GetCursorPosY() < bottom) ImGui::SetCursorPosY(bottom);
  if (labeledButton("Start", Icon::kPlay)) actions.start = card.id;
  const float width = ImGui::CalcTextSize("Dismiss").x + scaled(20);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
  if (textButton("Dismiss", {.size = ImVec2(width, 0)})) actions.dismiss = card.id;
}

}  // namespace

HintActions drawHintCards(const std::vector<HintCard>& cards, std::span<const PanelPlace> places) {
  HintActions actions;
  const std::size_t count = std::min(cards.size(), places.size());
  for (std::size_t i = 0; i < count; ++i) drawCard(cards[i], places[i], actions);
  return actions;
}

}  // namespace stipple
