#include "app/panels/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/panels/theme.h"

namespace stipple {

namespace {

ImU32 withOpacity(ImU32 color) {
  return ImGui::GetColorU32(color);
}

// Dark or light, whatever is read more easily on the color.
ImU32 inkOn(const Rgba8& color) {
  const double light = 0.299 * color.r + 0.587 * color.g + 0.114 * color.b;
  return withOpacity(light > 140 ? IM_COL32(20, 20, 20, 255) : IM_COL32(245, 245, 245, 255));
}

ImU32 groundOf(const ButtonOptions& options, bool isHovered, bool isHeld) {
  if (options.isOn) return accentColor();
  return ImGui::GetColorU32(isHeld      ? ImGuiCol_ButtonActive
                            : isHovered ? ImGuiCol_ButtonHovered
                                        : ImGuiCol_Button);
}

ImU32 inkOf(const ButtonOptions& options) {
  return options.isOn ? withOpacity(IM_COL32(28, 24, 18, 255)) : ImGui::GetColorU32(ImGuiCol_Text);
}

// A button's ground and behavior; what is on it follows.
struct Pressed {
  ImVec2 from, to;
  bool isHovered = false, wasClicked = false;

  ImVec2 center() const { return {(from.x + to.x) / 2, (from.y + to.y) / 2}; }
};

Pressed pressable(const char* id, ImVec2 size, const ButtonOptions& options) {
  Pressed pressed;
  pressed.wasClicked = ImGui::InvisibleButton(id, size);
  pressed.from = ImGui::GetItemRectMin();
  pressed.to = ImGui::GetItemRectMax();
  pressed.isHovered = ImGui::IsItemHovered();
  if (options.help) help(options.help);
  return pressed;
}

Pressed framedButton(const char* id, ImVec2 size, const ButtonOptions& options) {
  ImGui::BeginDisabled(!options.isEnabled);
  const Pressed pressed = pressable(id, size, options);
  const ImU32 ground = groundOf(options, pressed.isHovered, ImGui::IsItemActive());
  ImGui::GetWindowDrawList()->AddRectFilled(pressed.from, pressed.to, ground,
                                            ImGui::GetStyle().FrameRounding);
  return pressed;
}

void endFramedButton() {
  ImGui::EndDisabled();
}

void drawCentered(ImFont* font, const char* text, ImVec2 center, ImU32 color) {
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text);
  ImGui::GetWindowDrawList()->AddText(
      font, font->FontSize, ImVec2(std::round(center.x - size.x / 2), std::round(center.y - size.y / 2)),
      color, text);
}

float fractionOf(const ValueField& field) {
  const auto position = [&](float v) { return field.isLogarithmic ? std::log(v) : v; };
  const float low = position(field.min), high = position(field.max);
  return high > low ? std::clamp((position(field.value) - low) / (high - low), 0.0f, 1.0f) : 0.0f;
}

void drawField(const ValueField& field, const ImRect& box, bool isHovered, bool isActive) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImGuiStyle& style = ImGui::GetStyle();
  list.AddRectFilled(box.Min, box.Max,
                     ImGui::GetColorU32(isActive    ? ImGuiCol_FrameBgActive
                                        : isHovered ? ImGuiCol_FrameBgHovered
                                                    : ImGuiCol_FrameBg),
                     style.FrameRounding);
  // The filled part keeps the field's rounding: the same shape, cut where the value ends.
  const float end = std::round(box.Min.x + fractionOf(field) * box.GetWidth());
  list.PushClipRect(box.Min, ImVec2(end, box.Max.y), true);
  list.AddRectFilled(box.Min, box.Max,
                     ImGui::GetColorU32(isActive ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab),
                     style.FrameRounding);
  list.PopClipRect();

  const float y = box.Min.y + style.FramePadding.y;
  const float valueWidth = ImGui::CalcTextSize(field.text.c_str()).x;
  const float valueX = box.Max.x - style.FramePadding.x - valueWidth;
  const ImVec2 labelFrom(box.Min.x + style.FramePadding.x, y);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::RenderTextEllipsis(&list, labelFrom, ImVec2(valueX - style.ItemInnerSpacing.x, box.Max.y),
                            valueX - style.ItemInnerSpacing.x, valueX - style.ItemInnerSpacing.x, field.label,
                            nullptr, nullptr);
  ImGui::PopStyleColor();
  list.AddText(ImVec2(valueX, y), ImGui::GetColorU32(ImGuiCol_Text), field.text.c_str());
}

// Takes the mouse for a drag, or begins typing; returns whether the field is being typed into.
bool beginUse(ImGuiID id, bool isHovered) {
  if (ImGui::TempInputIsActive(id)) return true;
  const ImGuiIO& io = ImGui::GetIO();
  if (!isHovered || !io.MouseClicked[0]) return false;
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  ImGui::SetActiveID(id, window);
  ImGui::SetFocusID(id, window);
  ImGui::FocusWindow(window);
  return io.MouseDoubleClicked[0] || io.KeyCtrl;
}

}  // namespace

ImU32 toImGui(const Rgba8& color) {
  return withOpacity(IM_COL32(color.r, color.g, color.b, color.a));
}

ImU32 accentColor() {
  return ImGui::GetColorU32(ImGuiCol_PlotHistogram);
}

ImU32 accentInk() {
  return ImGui::GetColorU32(ImGuiCol_PlotLines);
}

std::optional<float> valueField(const ValueField& field) {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (window->SkipItems) return {};
  const ImGuiID id = window->GetID(field.label);
  const float width = field.width > 0 ? field.width : ImGui::GetContentRegionAvail().x;
  const ImVec2 from = window->DC.CursorPos;
  const ImRect box(from, ImVec2(from.x + width, from.y + ImGui::GetFrameHeight()));
  ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
  if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable)) return {};
  const bool isHovered = ImGui::ItemHoverable(box, id);
  float value = field.value;
  if (beginUse(id, isHovered)) {
    const bool typed = ImGui::TempInputScalar(box, id, field.label, ImGuiDataType_Float, &value, "%.4g",
                                              &field.min, &field.max);
    return typed && value != field.value ? std::optional(value) : std::nullopt;
  }
  // Over its width the field's whole range. Dear ImGui makes Shift ten times faster; here it is finer.
  const float speed = (field.max - field.min) / width * (ImGui::GetIO().KeyShift ? 0.01f : 1.0f);
  const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat |
                                 (field.isLogarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  const bool dragged =
      ImGui::DragBehavior(id, ImGuiDataType_Float, &value, speed, &field.min, &field.max, "%.6f", flags);
  const bool isActive = ImGui::GetActiveID() == id;
  if (isHovered || isActive) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  drawField(field, box, isHovered, isActive);
  if (field.help && !isActive) help(field.help);
  return dragged ? std::optional(value) : std::nullopt;
}

bool iconButton(const char* id, Icon icon, const ButtonOptions& options) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 size(options.size.x > 0 ? options.size.x : side, options.size.y > 0 ? options.size.y : side);
  const Pressed pressed = framedButton(id, size, options);
  drawIcon(*ImGui::GetWindowDrawList(), icon, pressed.center(), scaled(14), inkOf(options));
  endFramedButton();
  return pressed.wasClicked;
}

bool toolButton(const char* name, Icon icon, const ButtonOptions& options) {
  const Pressed pressed = framedButton(name, options.size, options);
  const float third = std::round((pressed.to.y - pressed.from.y) * 0.36f);
  drawIcon(*ImGui::GetWindowDrawList(), icon, ImVec2(pressed.center().x, pressed.from.y + third), scaled(18),
           inkOf(options));
  drawCentered(smallFont(), name, ImVec2(pressed.center().x, pressed.to.y - scaled(10)), inkOf(options));
  endFramedButton();
  return pressed.wasClicked;
}

bool labeledButton(const char* label, Icon icon, const ButtonOptions& options) {
  const float side = scaled(12), gap = scaled(7), padding = scaled(11);
  const float height = ImGui::GetFrameHeight();
  const ImVec2 size(padding + side + gap + ImGui::CalcTextSize(label).x + padding, height);
  const Pressed pressed = framedButton(label, size, options);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 center(pressed.from.x + padding + side / 2, pressed.center().y);
  drawIcon(list, icon, center, side, options.isOn ? inkOf(options) : accentInk());
  list.AddText(
      ImVec2(pressed.from.x + padding + side + gap, pressed.from.y + ImGui::GetStyle().FramePadding.y),
      inkOf(options), label);
  endFramedButton();
  return pressed.wasClicked;
}

bool textButton(const char* label, const ButtonOptions& options) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 text = ImGui::CalcTextSize(label);
  const ImVec2 size(options.size.x > 0 ? options.size.x : text.x + 2 * (style.FramePadding.x + scaled(4)),
                    options.size.y > 0 ? options.size.y : ImGui::GetFrameHeight());
  const Pressed pressed = framedButton(label, size, options);
  drawCentered(bodyFont(), label, pressed.center(), inkOf(options));
  endFramedButton();
  return pressed.wasClicked;
}

bool chip(const char* label, const ButtonOptions& options) {
  const ImVec2 size(options.size.x > 0 ? options.size.x : scaled(30), ImGui::GetFrameHeight());
  ButtonOptions plain = options;
  plain.isOn = false;
  const Pressed pressed = framedButton(label, size, plain);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  if (options.isOn) {
    list.AddRectFilled(pressed.from, pressed.to, ImGui::GetColorU32(ImGuiCol_ButtonActive), rounding);
    list.AddRectFilled(ImVec2(pressed.from.x + scaled(6), pressed.to.y - scaled(3)),
                       ImVec2(pressed.to.x - scaled(6), pressed.to.y - scaled(1)), accentColor());
  }
  drawCentered(bodyFont(), label, pressed.center(),
               ImGui::GetColorU32(options.isOn ? ImGuiCol_Text : ImGuiCol_TextDisabled));
  endFramedButton();
  return pressed.wasClicked;
}

bool link(const char* label) {
  const Pressed pressed = pressable(label, ImVec2(ImGui::CalcTextSize(label).x, ImGui::GetFrameHeight()), {});
  const float y = pressed.from.y + ImGui::GetStyle().FramePadding.y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(ImVec2(pressed.from.x, y), accentInk(), label);
  if (pressed.isHovered) {
    const float under = std::round(y + ImGui::GetFontSize() - scaled(1));
    list.AddRectFilled(ImVec2(pressed.from.x, under), ImVec2(pressed.to.x, under + scaled(1)), accentInk());
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  return pressed.wasClicked;
}

std::optional<bool> checkBox(const char* label, bool value, const ButtonOptions& options) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float side = scaled(16), height = ImGui::GetFrameHeight();
  ImGui::BeginDisabled(!options.isEnabled);
  const float width = side + scaled(8) + ImGui::CalcTextSize(label).x;
  const Pressed pressed = pressable(label, ImVec2(width, height), options);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = std::round(pressed.from.y + (height - side) / 2);
  const ImVec2 from(pressed.from.x, top), to(from.x + side, top + side);
  const ImGuiCol ground = pressed.isHovered ? ImGuiCol_ButtonHovered : ImGuiCol_Button;
  list.AddRectFilled(from, to, ImGui::GetColorU32(ground), scaled(3));
  if (value) {
    const ImVec2 tick[] = {{from.x + side * 0.22f, from.y + side * 0.52f},
                           {from.x + side * 0.42f, from.y + side * 0.72f},
                           {from.x + side * 0.79f, from.y + side * 0.29f}};
    list.AddPolyline(tick, 3, accentInk(), 0, 2 * overlayScale());
  }
  list.AddText(ImVec2(to.x + scaled(8), pressed.from.y + style.FramePadding.y),
               ImGui::GetColorU32(ImGuiCol_Text), label);
  ImGui::EndDisabled();
  return pressed.wasClicked ? std::optional(!value) : std::nullopt;
}

bool swatch(const char* id, const Rgba8& color, const SwatchOptions& options) {
  const Pressed pressed = pressable(id, options.size, {.help = options.help});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  list.AddRectFilled(pressed.from, pressed.to, toImGui({color.r, color.g, color.b, 255}), rounding);
  // Colors like the panel's ground have an edge, too.
  list.AddRect(pressed.from, pressed.to, ImGui::GetColorU32(ImGuiCol_Border), rounding, 0, scaled(1));
  if (options.isOn || pressed.isHovered) {
    const float line = scaled(2);
    const ImU32 ring = ImGui::GetColorU32(ImGuiCol_Text, options.isOn ? 1.0f : 0.5f);
    list.AddRect(ImVec2(pressed.from.x - line / 2, pressed.from.y - line / 2),
                 ImVec2(pressed.to.x + line / 2, pressed.to.y + line / 2), ring, rounding + line / 2, 0,
                 line);
  }
  drawCentered(smallFont(), options.text, pressed.center(), inkOn(color));
  return pressed.wasClicked;
}

std::optional<int> choice(const char* id, std::span<const std::string> names, int current) {
  std::optional<int> chosen;
  const float padding = ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding, padding));
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 center(from.x + ImGui::GetContentRegionAvail().x - scaled(13),
                      from.y + ImGui::GetFrameHeight() / 2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool isOpen = ImGui::BeginCombo(id, names[current].c_str(), ImGuiComboFlags_NoArrowButton);
  drawIcon(list, Icon::kChevron, center, scaled(12), ImGui::GetColorU32(ImGuiCol_TextDisabled));
  if (isOpen) {
    closeOnEscape();
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
      ImGui::PushID(i);
      if (ImGui::Selectable(names[i].c_str(), i == current)) chosen = i;
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
  return chosen;
}

void closeOnEscape() {
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) ImGui::CloseCurrentPopup();
}

void title(const std::string& text) {
  ImGui::PushFont(titleFont());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

void smallText(const std::string& text) {
  ImGui::PushFont(smallFont());
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void shortenedText(const std::string& text, const LineRoom& room) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFontSize(), height = std::max(room.height, size);
  const float width = std::clamp(room.width, 0.0f, ImGui::CalcTextSize(text.c_str()).x);
  ImGui::Dummy(ImVec2(width, height));
  const ImVec2 from(corner.x, corner.y + std::round((height - size) / 2));
  const ImVec2 to(corner.x + width, from.y + size);
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), from, to, to.x, to.x, text.c_str(), nullptr, nullptr);
}

void row(const char* name, const std::string& value) {
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(std::max(right - ImGui::CalcTextSize(value.c_str()).x, 0.0f));
  ImGui::TextUnformatted(value.c_str());
}

void help(const char* text) {
  constexpr float kDelay = 0.45f;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) ||
      ImGui::GetCurrentContext()->HoveredIdTimer < kDelay) {
    return;
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(260));
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace stipple
