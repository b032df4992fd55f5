#include "app/window/overlay_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/panels/theme.h"
#include "app/window/open_scan.h"
#include "app/window/process_state.h"

namespace stipple {

namespace {

constexpr ImU32 kShade = IM_COL32(0, 0, 0, 130);
constexpr std::size_t kKeptFrames = 90;
constexpr std::size_t kShownLabels = 12;

void drawLine(ImDrawList& list, const ScreenLine& line, float scale) {
  std::vector<ImVec2> points;
  for (const glm::vec2& p : line.points) points.emplace_back(p.x, p.y);
  const int flags = line.isClosed ? ImDrawFlags_Closed : ImDrawFlags_None;
  const auto count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, kShade, flags, 3.2f * scale);
  const ImU32 color = IM_COL32(line.color.r, line.color.g, line.color.b, 240);
  list.AddPolyline(points.data(), count, color, flags, 1.4f * scale);
}

void drawText(ImDrawList& list, const ScreenText& text, float scale) {
  const ImVec2 size = ImGui::CalcTextSize(text.text.c_str());
  const ImVec2 at(text.at.x + 10 * scale, text.at.y - size.y / 2), pad(6 * scale, 3 * scale);
  list.AddRectFilled(ImVec2(at.x - pad.x, at.y - pad.y), ImVec2(at.x + size.x + pad.x, at.y + size.y + pad.y),
                     IM_COL32(30, 30, 30, 215), 4 * scale);
  list.AddText(at, IM_COL32(235, 235, 235, 255), text.text.c_str());
}

bool isPaintable(const Attribute& attribute) {
  return attribute.type() != AttributeType::kVector3;
}

Rgba8 colorOf(const std::vector<double>& value) {
  const auto channel = [&](std::size_t at) {
    return static_cast<std::uint8_t>(std::clamp(at < value.size() ? value[at] : 255, 0.0, 255.0));
  };
  return {channel(0), channel(1), channel(2), 255};
}

bool isInteger(const Attribute& attribute) {
  return attribute.type() == AttributeType::kInt || attribute.type() == AttributeType::kUint;
}

std::vector<std::int64_t> labelsOf(const Attribute& attribute, std::int64_t chosen) {
  std::int64_t most = std::max<std::int64_t>(3, chosen);
  std::visit(
      [&]<class T>(const std::vector<T>& values) {
        if constexpr (std::is_integral_v<T>) {
          for (const T value : values) most = std::max(most, static_cast<std::int64_t>(value));
        }
      },
      attribute.column.values());
  std::vector<std::int64_t> labels;
  for (std::int64_t label = 1; label <= std::min<std::int64_t>(most, kShownLabels); ++label)
    labels.push_back(label);
  return labels;
}

PanelTool panelToolOf(const BrushSettings& settings, bool isSelecting) {
  if (isSelecting) return PanelTool::kSelect;
  if (settings.kind == BrushKind::kErase) return PanelTool::kErase;
  return settings.kind == BrushKind::kSmooth ? PanelTool::kSmooth : PanelTool::kPaint;
}

SymmetryAxis symmetryOf(const std::array<bool, 3>& planes) {
  if (planes[0]) return SymmetryAxis::kX;
  if (planes[1]) return SymmetryAxis::kY;
  return planes[2] ? SymmetryAxis::kZ : SymmetryAxis::kNone;
}

}  // namespace

void OverlayView::say(std::string sentence, std::string details) {
  sentence_ = std::move(sentence);
  details_ = std::move(details);
  said_.restart();
}

void OverlayView::noteFrame(const FrameNotes& notes) {
  frameTimes_.push_back(static_cast<float>(notes.milliseconds));
  if (frameTimes_.size() > kKeptFrames) frameTimes_.erase(frameTimes_.begin());
}

void OverlayView::showBrush(const BrushSettings& settings, bool isSelecting, const OpenScan& scan) {
  BrushModel brush;
  brush.tool = panelToolOf(settings, isSelecting);
  const bool isModel = settings.radiusUnit == RadiusUnit::kModel;
  brush.radiusUnit = isModel ? PanelRadiusUnit::kModel : PanelRadiusUnit::kPixels;
  brush.radius = static_cast<float>(isModel ? settings.radius : settings.radiusPx);
  brush.minRadius = isModel ? 0.1f * scan.extent.spacing : 2;
  brush.maxRadius = isModel ? 0.5f * scan.extent.sphere.radius : 500;
  brush.strength = static_cast<float>(settings.strength);
  brush.spacing = static_cast<float>(settings.spacing);
  brush.pressure = static_cast<PanelPressure>(settings.pressure);
  if (settings.symmetry != SymmetryAxis::kNone)
    brush.symmetry[static_cast<std::size_t>(settings.symmetry) - 1] = true;
  brush.onlyVisible = settings.onlyVisible;
  brush.onlySelection = !settings.within.empty();
  brush.hasSelection = scan.document.points().has("selection");
  model_.brush = std::move(brush);
  painted_.clear();
  if (!isSelecting) showPaint(settings, scan);
}

// The attributes that can be painted, the one at hand among them even where it is still to be made.
void OverlayView::showPaint(const BrushSettings& settings, const OpenScan& scan) {
  BrushModel& brush = *model_.brush;
  const PointSet& points = scan.document.points();
  painted_.push_back("color");
  if (settings.attribute != "color" && !points.has(settings.attribute))
    painted_.push_back(settings.attribute);
  for (const Attribute& attribute : points.attributes()) {
    const bool isSelection = attribute.name.starts_with("selection");
    if (attribute.name != "color" && isPaintable(attribute) && !isSelection)
      painted_.push_back(attribute.name);
  }
  brush.attributes = painted_;
  brush.attribute = static_cast<int>(std::ranges::find(painted_, settings.attribute) - painted_.begin());
  const Attribute* attribute = points.find(settings.attribute);
  const bool isColor = attribute ? attribute->type() == AttributeType::kColor : settings.value.size() >= 3;
  if (isColor) {
    brush.paint = PaintedColor{.color = colorOf(settings.value), .recent = recentColors_};
    return;
  }
  const double value = settings.value.empty() ? 1 : settings.value[0];
  const auto label = static_cast<std::int64_t>(value);
  if (!attribute) {
    brush.paint = PaintedLabel{.label = label, .labels = {1, 2, 3}};
  } else if (isInteger(*attribute)) {
    brush.paint = PaintedLabel{.label = label, .labels = labelsOf(*attribute, label)};
  } else {
    brush.paint = PaintedNumber{.value = static_cast<float>(value)};
  }
}

void OverlayView::showProcess(const std::optional<ProcessState>& process) {
  model_.curve.reset();
  if (!process) return;
  CurveModel curve;
  curve.process = process->title;
  curve.quantity = "change per step";
  curve.values.assign(process->curve.begin(), process->curve.end());
  curve.steps = process->steps;
  curve.state = process->isPaused ? ProcessPhase::kPaused : ProcessPhase::kRunning;
  curve.fraction = process->fraction;
  curve.secondsLeft = process->secondsLeft;
  model_.curve = std::move(curve);
}

void OverlayView::countLabels(const OpenScan& scan, const std::string& name) {
  const Attribute* attribute = scan.document.points().find(name);
  if (!attribute || (countedColumn_ == attribute->column.id() && model_.legend)) return;
  countedColumn_ = attribute->column.id();
  std::map<std::int64_t, std::int64_t> counts;
  std::visit(
      [&]<class T>(const std::vector<T>& values) {
        if constexpr (std::is_integral_v<T>) {
          for (const T value : values) ++counts[static_cast<std::int64_t>(value)];
        }
      },
      attribute->column.values());
  LabelLegend legend;
  for (const auto& [label, points] : counts) legend.labels.push_back({.label = label, .points = points});
  model_.legend = LegendModel{.attribute = name, .content = std::move(legend)};
}

void OverlayView::showLegend(const OpenScan* scan) {
  const PointColors none;
  const PointColors& colors = scan ? scan->follower.colors() : none;
  const std::string& name = colors.source().attribute;
  if (colors.kind() == PointColors::Kind::kLabels) return countLabels(*scan, name);
  model_.legend.reset();
  if (colors.kind() != PointColors::Kind::kNumbers) return;
  const auto [low, high] = colors.range();
  model_.legend = LegendModel{
      .attribute = name, .content = ScalarLegend{.colormap = colors.colormap(), .low = low, .high = high}};
}

void OverlayView::showStatistics(const OpenScan* scan, const std::optional<FrameNotes>& notes,
                                 const char* backend) {
  model_.statistics.reset();
  if (!showsStatistics || !scan || !notes) return;
  model_.statistics = StatisticsModel{.frameMilliseconds = frameTimes_,
                                      .points = scan->document.points().size(),
                                      .splats = notes->splats,
                                      .tau = notes->tau,
                                      .backEnd = backend};
}

bool OverlayView::isAnimated() const {
  return !sentence_.empty();
}

OverlayActions OverlayView::draw(const std::vector<ScreenLine>& lines, const std::vector<ScreenText>& texts) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const ScreenLine& line : lines) drawLine(list, line, overlayScale());
  for (const ScreenText& text : texts) drawText(list, text, overlayScale());
  model_.cards = cards;
  model_.message.reset();
  if (!sentence_.empty()) {
    model_.message = MessageModel{.text = sentence_,
                                  .hasDetails = !details_.empty(),
                                  .ageSeconds = static_cast<float>(said_.elapsed()) / 1000};
  }
  const OverlayActions actions = drawOverlay(model_);
  if (actions.message.dismiss) sentence_.clear();
  if (actions.brush.color) {
    std::erase(recentColors_, *actions.brush.color);
    recentColors_.insert(recentColors_.begin(), *actions.brush.color);
    if (recentColors_.size() > 8) recentColors_.pop_back();
  }
  return actions;
}

bool applyBrushActions(const BrushActions& actions, const std::vector<std::string>& attributes,
                       const OpenScan& scan, BrushSettings& settings) {
  const bool isAnything = actions.attribute || actions.color || actions.label || actions.addLabel ||
                          actions.number || actions.radius || actions.strength || actions.spacing ||
                          actions.radiusUnit || actions.symmetry || actions.onlyVisible ||
                          actions.onlySelection || actions.pressure;
  if (!isAnything) return false;
  if (actions.attribute && static_cast<std::size_t>(*actions.attribute) < attributes.size()) {
    settings.attribute = attributes[static_cast<std::size_t>(*actions.attribute)];
    const Attribute* attribute = scan.document.points().find(settings.attribute);
    const bool isColor =
        attribute ? attribute->type() == AttributeType::kColor : settings.attribute == "color";
    if (isColor != (settings.value.size() >= 3))
      settings.value = isColor ? std::vector<double>{222, 56, 32} : std::vector<double>{1};
  }
  if (actions.color)
    settings.value = {double(actions.color->r), double(actions.color->g), double(actions.color->b)};
  if (actions.label) settings.value = {static_cast<double>(*actions.label)};
  if (actions.addLabel && !settings.value.empty()) {
    const Attribute* attribute = scan.document.points().find(settings.attribute);
    const auto labels =
        attribute && isInteger(*attribute) ? labelsOf(*attribute, 3) : std::vector<std::int64_t>{1, 2, 3};
    settings.value = {static_cast<double>(labels.back() + 1)};
  }
  if (actions.number) settings.value = {*actions.number};
  if (actions.radiusUnit)
    settings.radiusUnit =
        *actions.radiusUnit == PanelRadiusUnit::kModel ? RadiusUnit::kModel : RadiusUnit::kPixels;
  if (actions.radius)
    (settings.radiusUnit == RadiusUnit::kModel ? settings.radius : settings.radiusPx) = *actions.radius;
  if (actions.strength) settings.strength = std::max(0.01f, *actions.strength);
  if (actions.spacing) settings.spacing = std::max(0.02f, *actions.spacing);
  if (actions.symmetry) {
    const std::array<bool, 3> before{settings.symmetry == SymmetryAxis::kX,
                                     settings.symmetry == SymmetryAxis::kY,
                                     settings.symmetry == SymmetryAxis::kZ};
    std::array<bool, 3> fresh = *actions.symmetry;
    for (std::size_t axis = 0; axis < 3; ++axis) fresh[axis] = fresh[axis] && !before[axis];
    settings.symmetry = symmetryOf(std::ranges::count(fresh, true) ? fresh : *actions.symmetry);
  }
  if (actions.pressure) settings.pressure = static_cast<PressureMapping>(*actions.pressure);
  if (actions.onlyVisible) settings.onlyVisible = *actions.onlyVisible;
  if (actions.onlySelection) settings.within = *actions.onlySelection ? "selection" : "";
  return true;
}

}  // namespace stipple
