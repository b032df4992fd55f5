#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/panels/panel_window.h"
#include "core/points/attribute.h"

namespace stipple {

enum class PanelTool { kPaint, kErase, kSmooth, kSelect };
enum class PanelRadiusUnit { kModel, kPixels };
/// What the pressure of a pen scales.
enum class PanelPressure { kNone, kSize, kStrength };

/// What paint leaves behind: a color, ...
struct PaintedColor {
  Rgba8 color{};
  std::vector<Rgba8> recent = {};  ///< latest first; the first eight are shown
};
/// ... one of the labels in use (seeds, segments), ...
struct PaintedLabel {
  std::int64_t label = 0;
  std::vector<std::int64_t> labels = {};
};
/// ... or a number (masks, weights).
struct PaintedNumber {
  float value = 1, min = 0, max = 1;
};

struct BrushModel {
  std::vector<PanelTool> tools = {PanelTool::kPaint, PanelTool::kErase, PanelTool::kSmooth,
                                  PanelTool::kSelect};
  PanelTool tool = PanelTool::kPaint;
  std::vector<std::string> attributes = {};  ///< titles of those that can be painted
  int attribute = 0;                         ///< index of the one being painted
  std::variant<std::monostate, PaintedColor, PaintedLabel, PaintedNumber> paint = {};
  PanelRadiusUnit radiusUnit = PanelRadiusUnit::kPixels;
  float radius = 30, minRadius = 1, maxRadius = 500;  ///< in the radius unit
  float strength = 1;                                 ///< 0..1
  float spacing = 0.25f;                              ///< of dabs, in radii
  PanelPressure pressure = PanelPressure::kSize;
  std::array<bool, 3> symmetry{};  ///< planes x = 0, y = 0, z = 0
  bool onlyVisible = true, onlySelection = false;
  bool hasSelection = false;  ///< otherwise "only selection" cannot be turned on
};

/// What the user changed in this frame.
struct BrushActions {
  std::optional<PanelTool> tool;
  std::optional<int> attribute;
  std::optional<Rgba8> color;
  std::optional<std::int64_t> label;
  bool addLabel = false;
  std::optional<float> number, radius, strength, spacing;
  std::optional<PanelRadiusUnit> radiusUnit;
  std::optional<PanelPressure> pressure;
  std::optional<std::array<bool, 3>> symmetry;
  std::optional<bool> onlyVisible, onlySelection;
};

BrushActions drawBrushPanel(const BrushModel& model, const PanelPlace& place);

}  // namespace stipple
