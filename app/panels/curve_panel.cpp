#include "app/panels/curve_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/panels/curve_scale.h"
#include "app/panels/numbers.h"
#include "app/panels/theme.h"
#include "app/panels/widgets.h"

namespace stipple {

namespace {

std::string stateOf(const CurveModel& model) {
  if (model.state == ProcessPhase::kFinished) return "finished";
  if (model.state == ProcessPhase::kPaused) return "paused";
  if (!model.fraction) return "running";
  const std::string percent = fmt::format("{:.0f} %", 100 * std::clamp(*model.fraction, 0.0, 1.0));
  return model.secondsLeft ? percent + ", " + spokenDuration(*model.secondsLeft) + " left" : percent;
}

void drawHead(const CurveModel& model) {
  const std::string state = stateOf(model);
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(smallFont());
  const float stateWidth = ImGui::CalcTextSize(state.c_str()).x;
  ImGui::PopFont();
  ImGui::PushFont(titleFont());
  shortenedText(model.process, {.width = ImGui::GetContentRegionAvail().x - stateWidth - scaled(10)});
  ImGui::PopFont();
  ImGui::SameLine(right - stateWidth);
  // On the line of the larger letters.
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + scaled(2));
  smallText(state);
}

void drawProgress(const CurveModel& model) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = scaled(3);
  ImGui::Dummy(ImVec2(width, height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = height / 2;
  list.AddRectFilled(from, ImVec2(from.x + width, from.y + height), ImGui::GetColorU32(ImGuiCol_FrameBg),
                     rounding);
  const double fraction = model.state == ProcessPhase::kFinished ? 1 : std::clamp(*model.fraction, 0.0, 1.0);
  const float end = std::round(from.x + width * static_cast<float>(fraction));
  if (end > from.x) list.AddRectFilled(from, ImVec2(end, from.y + height), accentColor(), rounding);
}

struct Plot {
  ImVec2 from, to;

  float y(double height) const { return to.y - static_cast<float>(height) * (to.y - from.y); }
};

void drawTicks(ImDrawList& list, const Plot& plot, const CurveScale& scale) {
  constexpr int kTicks = 4;
  ImFont* font = smallFont();
  const float half = std::round(font->FontSize / 2);
  for (const double value : ticksOf(scale, kTicks)) {
    const float y = std::round(plot.y(scale.heightOf(value)));
    list.AddRectFilled(ImVec2(plot.from.x, y), ImVec2(plot.to.x, y + std::max(1.0f, scaled(1))),
                       ImGui::GetColorU32(ImGuiCol_Border));
    // Where its text has room within the plot.
    if (y - half < plot.from.y || y + half > plot.to.y) continue;
    const std::string text = shortNumber(value);
    const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
    list.AddText(font, font->FontSize, ImVec2(plot.from.x - scaled(6) - width, y - half),
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
  }
}

// Many values share a pixel: its column shows the least and the greatest of them.
void drawValues(ImDrawList& list, const Plot& plot, const CurveScale& scale,
                const std::vector<double>& values) {
  const auto count = static_cast<std::int64_t>(values.size());
  const auto width = static_cast<std::int64_t>(plot.to.x - plot.from.x);
  const std::int64_t columns = std::min(count, std::max<std::int64_t>(width, 1));
  for (std::int64_t column = 0; column < columns; ++column) {
    const auto begin = values.begin() + column * count / columns,
               end = values.begin() + (column + 1) * count / columns;
    const auto [least, most] = std::minmax_element(begin, end);
    const float x = plot.from.x + float(width) * (columns > 1 ? float(column) / float(columns - 1) : 0.5f);
    list.PathLineTo(ImVec2(x, plot.y(scale.heightOf(*least))));
    if (*most != *least) list.PathLineTo(ImVec2(x, plot.y(scale.heightOf(*most))));
  }
  const ImVec2 last = list._Path.back();
  list.PathStroke(accentInk(), 0, 1.5f * overlayScale());
  list.AddCircleFilled(last, 2.5f * overlayScale(), accentInk());
}

void drawPlot(const CurveModel& model) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, scaled(84));
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Plot plot{{from.x + scaled(44), from.y}, {from.x + size.x - scaled(4), from.y + size.y}};
  const CurveScale scale = scaleFor(model.values);
  drawTicks(list, plot, scale);
  if (!model.values.empty()) drawValues(list, plot, scale, model.values);
}

void drawLastValue(const CurveModel& model) {
  const std::string steps = groupedCount(model.steps) + (model.steps == 1 ? " step" : " steps");
  if (model.quantity.empty() || model.values.empty()) return smallText(steps);
  row(model.quantity.c_str(), shortNumber(model.values.back()));
  row("Steps", groupedCount(model.steps));
}

void drawButtons(const CurveModel& model, CurveActions& actions) {
  const float gap = scaled(4);
  const ImVec2 size(scaled(38), scaled(26));
  const bool isOver = model.state == ProcessPhase::kFinished, isPaused = model.state == ProcessPhase::kPaused;
  const bool canBePaused = model.canBePaused && !isOver;
  if (isPaused) {
    actions.resume = iconButton("##resume", Icon::kPlay, {.help = "Go on", .size = size});
  } else {
    actions.pause =
        iconButton("##pause", Icon::kPause, {.isEnabled = canBePaused, .help = "Pause", .size = size});
  }
  ImGui::SameLine(0, gap);
  actions.step = iconButton("##step", Icon::kStep,
                            {.isEnabled = canBePaused, .help = "One step, then pause", .size = size});
  ImGui::SameLine(0, gap);
  actions.stop =
      iconButton("##stop", Icon::kStop,
                 {.isEnabled = canBePaused, .help = "Stop and keep what was reached", .size = size});
  const float width = ImGui::CalcTextSize("Cancel").x + scaled(28);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
  if (isOver) {
    actions.close = textButton("Close", {.size = ImVec2(width, size.y)});
  } else {
    actions.cancel = textButton(
        "Cancel", {.help = "Stop and go back to the state before it", .size = ImVec2(width, size.y)});
  }
}

}  // namespace

CurveActions drawCurvePanel(const CurveModel& model, const PanelPlace& place) {
  CurveActions actions;
  const PanelWindow window("curve", place);
  drawHead(model);
  if (model.fraction) drawProgress(model);
  if (!model.quantity.empty()) drawPlot(model);
  drawLastValue(model);
  ImGui::Spacing();
  drawButtons(model, actions);
  return actions;
}

}  // namespace stipple
