#include "app/panels/brush_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/panels/numbers.h"
#include "app/panels/theme.h"
#include "app/panels/widgets.h"
#include "render/appearance/colormap.h"

namespace stipple {

namespace {

struct ToolFace {
  const char* name;
  Icon icon;
  const char* help;
};

ToolFace faceOf(PanelTool tool) {
  switch (tool) {
    case PanelTool::kPaint:
      return {"Paint", Icon::kPaint, "Paint the attribute below. Ctrl erases, Shift smooths."};
    case PanelTool::kErase:
      return {"Erase", Icon::kErase, "Set the attribute back to what it is where nothing was painted."};
    case PanelTool::kSmooth:
      return {"Smooth", Icon::kSmooth, "Even out the attribute under the brush."};
    case PanelTool::kSelect:
      break;
  }
  return {"Select", Icon::kSelect, "Select points under the brush. Ctrl removes them from the selection."};
}

// Width of one of `count` items that share the line, all but the last cut to whole pixels.
float sharedWidth(int count, float gap) {
  return std::floor((ImGui::GetContentRegionAvail().x - gap * float(count - 1)) / float(count));
}

void drawTools(const BrushModel& model, BrushActions& actions) {
  const float gap = scaled(4);
  const ImVec2 size(sharedWidth(static_cast<int>(model.tools.size()), gap), scaled(46));
  for (const PanelTool& tool : model.tools) {
    if (&tool != &model.tools.front()) ImGui::SameLine(0, gap);
    const ToolFace face = faceOf(tool);
    if (toolButton(face.name, face.icon, {.isOn = tool == model.tool, .help = face.help, .size = size})) {
      actions.tool = tool;
    }
  }
}

void drawAttributes(const BrushModel& model, BrushActions& actions) {
  if (model.attributes.empty()) return;
  const int current = std::clamp(model.attribute, 0, static_cast<int>(model.attributes.size()) - 1);
  actions.attribute = choice("##attribute", model.attributes, current);
}

std::optional<Rgba8> pickColor(const Rgba8& color) {
  float channels[3] = {color.r / 255.0f, color.g / 255.0f, color.b / 255.0f};
  ImGui::SetNextItemWidth(scaled(200));
  constexpr ImGuiColorEditFlags kFlags =
      ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview | ImGuiColorEditFlags_NoLabel |
      ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueBar;
  if (!ImGui::ColorPicker3("##picker", channels, kFlags)) return {};
  const auto toByte = [](float channel) { return static_cast<std::uint8_t>(std::lround(channel * 255)); };
  return Rgba8{toByte(channels[0]), toByte(channels[1]), toByte(channels[2]), 255};
}

void drawPaint(const PaintedColor& paint, BrushActions& actions) {
  constexpr int kRecent = 8;
  const float gap = scaled(4);
  const ImVec2 wide(ImGui::GetContentRegionAvail().x, scaled(26));
  if (swatch("##color", paint.color, {.text = "", .size = wide, .help = "Choose a color"})) {
    ImGui::OpenPopup("choose color");
  }
  // Beside the panel, so that the rest of it stays in sight.
  const ImVec2 panel = ImGui::GetWindowPos();
  const ImVec2 popup(panel.x + ImGui::GetWindowWidth() + scaled(8), ImGui::GetItemRectMin().y);
  const ImVec2 side(sharedWidth(kRecent, gap), scaled(18));
  for (int i = 0; i < std::min<int>(kRecent, static_cast<int>(paint.recent.size())); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::PushID(i);
    const Rgba8& color = paint.recent[i];
    if (swatch("##recent", color, {.isOn = color == paint.color, .size = side})) actions.color = color;
    ImGui::PopID();
  }
  ImGui::SetNextWindowPos(popup, ImGuiCond_Appearing);
  if (ImGui::BeginPopup("choose color")) {
    closeOnEscape();
    if (const auto color = pickColor(paint.color)) actions.color = color;
    ImGui::EndPopup();
  }
}

void drawPaint(const PaintedLabel& paint, BrushActions& actions) {
  constexpr int kColumns = 7;
  const float gap = scaled(6);
  const ImVec2 size(sharedWidth(kColumns, gap), scaled(24));
  int column = 0;
  const auto nextCell = [&] {
    if (column++ % kColumns != 0) ImGui::SameLine(0, gap);
  };
  for (const std::int64_t label : paint.labels) {
    nextCell();
    const std::string text = std::to_string(label);
    if (swatch(fmt::format("##{}", text).c_str(), labelColor(label),
               {.isOn = label == paint.label, .text = text.c_str(), .size = size})) {
      actions.label = label;
    }
  }
  nextCell();
  actions.addLabel = iconButton("##add", Icon::kAdd, {.help = "A new label", .size = size});
}

void drawPaint(const PaintedNumber& paint, BrushActions& actions) {
  actions.number = valueField({.label = "Value",
                               .value = paint.value,
                               .min = paint.min,
                               .max = paint.max,
                               .text = shortNumber(paint.value)});
}

void drawPaint(std::monostate, BrushActions&) {}

std::string percent(float fraction) {
  return fmt::format("{:.0f} %", 100 * fraction);
}

void drawRadius(const BrushModel& model, BrushActions& actions) {
  const bool inPixels = model.radiusUnit == PanelRadiusUnit::kPixels;
  const float unitWidth = scaled(54), gap = scaled(4);
  actions.radius =
      valueField({.label = "Radius",
                  .value = model.radius,
                  .min = model.minRadius,
                  .max = model.maxRadius,
                  .isLogarithmic = true,
                  .text = inPixels ? fmt::format("{:.0f} px", model.radius) : shortNumber(model.radius),
                  .width = ImGui::GetContentRegionAvail().x - unitWidth - gap,
                  .help = "[ and ] or Alt and the wheel, too; F and a drag in the view."});
  ImGui::SameLine(0, gap);
  const char* help = inPixels ? "On the screen: the same size at every distance. Click for the model's units."
                              : "In the model's units: the same place at every distance. Click for pixels.";
  if (textButton(inPixels ? "screen" : "model", {.help = help, .size = ImVec2(unitWidth, 0)})) {
    actions.radiusUnit = inPixels ? PanelRadiusUnit::kModel : PanelRadiusUnit::kPixels;
  }
}

void drawStroke(const BrushModel& model, BrushActions& actions) {
  drawRadius(model, actions);
  actions.strength =
      valueField({.label = "Strength", .value = model.strength, .text = percent(model.strength)});
  actions.spacing = valueField({.label = "Spacing",
                                .value = model.spacing,
                                .min = 0.02f,
                                .max = 1,
                                .text = percent(model.spacing),
                                .help = "From one dab to the next, in radii of the brush."});
}

// One of two, or none.
void drawPressure(const BrushModel& model, BrushActions& actions) {
  const float gap = scaled(4), sizeWidth = scaled(44), strengthWidth = scaled(66);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Pen");
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - sizeWidth - strengthWidth -
                  gap);
  const auto offer = [&](const char* name, PanelPressure what, float width, const char* help) {
    const bool isOn = model.pressure == what;
    if (chip(name, {.isOn = isOn, .help = help, .size = ImVec2(width, 0)}))
      actions.pressure = isOn ? PanelPressure::kNone : what;
  };
  ImGui::PushID("pen");  // there is a field for the strength, too
  offer("Size", PanelPressure::kSize, sizeWidth, "The pressure of a pen scales the radius.");
  ImGui::SameLine(0, gap);
  offer("Strength", PanelPressure::kStrength, strengthWidth, "The pressure of a pen scales the strength.");
  ImGui::PopID();
}

void drawLimits(const BrushModel& model, BrushActions& actions) {
  drawPressure(model, actions);
  const float chipWidth = scaled(34), gap = scaled(4);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Symmetry");
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - 3 * chipWidth - 2 * gap);
  constexpr const char* kAxes[] = {"X", "Y", "Z"};
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0, gap);
    if (!chip(kAxes[axis], {.isOn = model.symmetry[axis], .size = ImVec2(chipWidth, 0)})) continue;
    actions.symmetry = model.symmetry;
    (*actions.symmetry)[axis] = !model.symmetry[axis];
  }
  actions.onlyVisible = checkBox("Only what is visible", model.onlyVisible,
                                 {.help = "Points hidden behind the surface stay as they are."});
  // The two belong together.
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + scaled(1));
  actions.onlySelection = checkBox("Only the selection", model.onlySelection,
                                   {.isEnabled = model.hasSelection || model.onlySelection});
}

}  // namespace

BrushActions drawBrushPanel(const BrushModel& model, const PanelPlace& place) {
  BrushActions actions;
  const PanelWindow window("brush", place);
  drawTools(model, actions);
  ImGui::Spacing();
  drawAttributes(model, actions);
  std::visit([&](const auto& paint) { drawPaint(paint, actions); }, model.paint);
  ImGui::Spacing();
  drawStroke(model, actions);
  ImGui::Spacing();
  drawLimits(model, actions);
  return actions;
}

}  // namespace stipple
