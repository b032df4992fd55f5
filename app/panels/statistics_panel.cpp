#include "app/panels/statistics_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/panels/numbers.h"
#include "app/panels/theme.h"
#include "app/panels/widgets.h"

namespace stipple {

namespace {

// Bars of the latest frames against a line at 60 frames a second; what takes longer than three of those is
// cut.
void drawFrameTimes(const std::vector<float>& milliseconds) {
  constexpr float kSmooth = 1000.0f / 60, kMost = 3 * kSmooth;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, scaled(36));
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 to(from.x + size.x, from.y + size.y);
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(3));
  const float width = std::max(scaled(2), 1.0f), pitch = width + std::max(std::floor(overlayScale()), 1.0f);
  float x = to.x - scaled(4) - width;
  for (auto i = milliseconds.rbegin(); i != milliseconds.rend() && x >= from.x + scaled(4); ++i, x -= pitch) {
    const float height =
        std::max(std::round(std::clamp(*i / kMost, 0.0f, 1.0f) * (size.y - scaled(6))), 1.0f);
    const float bottom = to.y - scaled(3);
    const ImU32 color = *i > 2 * kSmooth ? accentColor() : ImGui::GetColorU32(ImGuiCol_TextDisabled);
    list.AddRectFilled(ImVec2(x, bottom - height), ImVec2(x + width, bottom), color);
  }
  const float smooth = std::round(to.y - scaled(3) - (size.y - scaled(6)) / 3);
  list.AddRectFilled(ImVec2(from.x, smooth), ImVec2(to.x, smooth + std::max(scaled(1), 1.0f)),
                     ImGui::GetColorU32(ImGuiCol_Text, 0.22f));
}

}  // namespace

void drawStatisticsPanel(const StatisticsModel& model, const PanelPlace& place) {
  const PanelWindow window("statistics", place);
  const bool hasFrames = !model.frameMilliseconds.empty();
  row("Frame", hasFrames ? fmt::format("{:.1f} ms", model.frameMilliseconds.back()) : "none yet");
  drawFrameTimes(model.frameMilliseconds);
  row("Splats", roundedCount(model.splats));
  row("Points", groupedCount(model.points));
  row("Detail \u03c4", fmt::format("{:.1f} px", model.tau));
  row("Drawn by", model.backEnd);
}

}  // namespace stipple
