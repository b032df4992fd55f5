#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>

#include "app/panels/icons.h"
#include "core/points/attribute.h"

namespace stipple {

ImU32 toImGui(const Rgba8& color);
/// Of the style, with the current opacity: for areas, and for lines and letters.
ImU32 accentColor();
ImU32 accentInk();

/// A number in a field with its name at the left: dragging changes it (with Shift finely), a double click or
/// Ctrl and a click types it.
struct ValueField {
  const char* label = "";  ///< unique in its window
  float value = 0, min = 0, max = 1;
  bool isLogarithmic = false;  ///< min > 0
  std::string text = {};       ///< the number as shown, with its unit
  float width = 0;             ///< pixels; 0: all that is left of the line
  const char* help = nullptr;
};
std::optional<float> valueField(const ValueField& field);

struct ButtonOptions {
  bool isOn = false;  ///< in the accent color
  bool isEnabled = true;
  const char* help = nullptr;
  ImVec2 size{};  ///< pixels; 0: by its content
};
bool iconButton(const char* id, Icon icon, const ButtonOptions& options = {});
/// The name below the icon, small.
bool toolButton(const char* name, Icon icon, const ButtonOptions& options);
/// The name beside the icon.
bool labeledButton(const char* label, Icon icon, const ButtonOptions& options = {});
bool textButton(const char* label, const ButtonOptions& options = {});
/// A small button that stays pressed: lighter, with a line in the accent color.
bool chip(const char* label, const ButtonOptions& options = {});
/// A text that acts, in the accent color.
bool link(const char* label);
/// Returns the new value where it was clicked.
std::optional<bool> checkBox(const char* label, bool value, const ButtonOptions& options = {});

/// A field that opens a list over the whole line. Returns the index of what was chosen. `names` has
/// `current`.
std::optional<int> choice(const char* id, std::span<const std::string> names, int current);

struct SwatchOptions {
  bool isOn = false;
  const char* text = "";  ///< in the middle, black or white by the color
  ImVec2 size{};          ///< pixels
  const char* help = nullptr;
};
bool swatch(const char* id, const Rgba8& color, const SwatchOptions& options);

/// In an open popup.
void closeOnEscape();

void title(const std::string& text);
void smallText(const std::string& text);
struct LineRoom {
  float width = 0;   ///< pixels
  float height = 0;  ///< the text stands in the middle; 0: as high as the text
};
/// One line, cut with an ellipsis where it is wider than its room.
void shortenedText(const std::string& text, const LineRoom& room);
/// A dim name at the left and its value at the right end of the line.
void row(const char* name, const std::string& value);
/// For the item before; wraps.
void help(const char* text);

}  // namespace stipple
