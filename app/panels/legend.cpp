#include "app/panels/legend.h"

#include <algorithm>
#include <cmath>

#include "app/panels/numbers.h"
#include "app/panels/theme.h"
#include "app/panels/widgets.h"

namespace stipple {

namespace {

// A row of pixels has one color: as many steps as the bar is high.
void drawBar(ImDrawList& list, Colormap map, ImVec2 from, ImVec2 to) {
  const int rows = static_cast<int>(to.y - from.y);
  for (int i = 0; i < rows; ++i) {
    const float y = from.y + float(i);
    const double t = 1 - (i + 0.5) / rows;
    list.AddRectFilled(ImVec2(from.x, y), ImVec2(to.x, y + 1), toImGui(mapColor(map, t)));
  }
}

void drawContent(const ScalarLegend& legend, LegendActions&) {
  constexpr int kTicks = 5;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float half = std::round(ImGui::GetFontSize() / 2);
  const ImVec2 from(corner.x, corner.y + half), to(corner.x + scaled(16), from.y + scaled(150));
  ImGui::Dummy(ImVec2(ImGui::GetContentRegionAvail().x, to.y - corner.y + half));
  drawBar(list, legend.colormap, from, to);
  const double range = legend.high - legend.low;
  if (!std::isfinite(range)) return;
  const auto drawTick = [&](double value, float y) {
    y = std::round(y);
    list.AddRectFilled(ImVec2(to.x + scaled(2), y), ImVec2(to.x + scaled(7), y + std::max(scaled(1), 1.0f)),
                       ImGui::GetColorU32(ImGuiCol_TextDisabled));
    list.AddText(ImVec2(to.x + scaled(12), y - half), ImGui::GetColorU32(ImGuiCol_Text),
                 shortNumber(value, 4).c_str());
  };
  if (!(range > 0)) {
    drawTick(legend.low, (from.y + to.y) / 2);
    return;
  }
  for (const double value : legendTicks(legend.low, legend.high, kTicks)) {
    drawTick(value, static_cast<float>(to.y - (value - legend.low) / range * (to.y - from.y)));
  }
}

void drawContent(const LabelLegend& legend, LegendActions& actions) {
  const ImVec2 size(scaled(30), scaled(18));
  for (const auto& [label, points] : legend.labels) {
    const std::string name = std::to_string(label);
    ImGui::PushID(name.c_str());
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const float top = ImGui::GetCursorPosY();
    if (swatch("##label", labelColor(label), {.text = name.c_str(), .size = size})) actions.label = label;
    const std::string count = groupedCount(points);
    ImGui::SameLine(right - ImGui::CalcTextSize(count.c_str()).x);
    ImGui::SetCursorPosY(top + std::round((size.y - ImGui::GetFontSize()) / 2));
    ImGui::TextUnformatted(count.c_str());
    ImGui::PopID();
  }
  if (legend.labels.empty()) smallText("nothing is labeled yet");
}

}  // namespace

LegendActions drawLegend(const LegendModel& model, const PanelPlace& place) {
  LegendActions actions;
  const PanelWindow window("legend", place);
  const auto* scalar = std::get_if<ScalarLegend>(&model.content);
  ImGui::PushFont(titleFont());
  shortenedText(model.attribute, {.width = ImGui::GetContentRegionAvail().x});
  ImGui::PopFont();
  smallText(scalar ? (scalar->unit.empty() ? "no unit" : scalar->unit) : "points of each label");
  ImGui::Spacing();
  std::visit([&](const auto& content) { drawContent(content, actions); }, model.content);
  return actions;
}

}  // namespace stipple
