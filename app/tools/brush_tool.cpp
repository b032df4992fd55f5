#include "app/tools/brush_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/tools/navigation.h"

namespace stipple {

namespace {

// Sizes that can be seen and held.
constexpr double kLeastRadiusPx = 1, kMostRadiusPx = 2000;
constexpr double kSizeStep = 1.1;
constexpr double kLeastSpacing = 0.02;  // radii
constexpr double kStrengthPerPx = 1.0 / 300, kLeastStrength = 0.01;

double radiusAt(const BrushSettings& settings, float pixelsPerUnit) {
  if (settings.radiusUnit == RadiusUnit::kModel) return settings.radius;
  return settings.radiusPx / static_cast<double>(pixelsPerUnit);
}

BrushKind kindOf(const BrushSettings& settings, const Modifiers& modifiers) {
  if (settings.kind == BrushKind::kSmooth || (modifiers.shift && !modifiers.ctrl)) return BrushKind::kSmooth;
  const bool erases = (settings.kind == BrushKind::kErase) != modifiers.ctrl;
  return erases ? BrushKind::kErase : BrushKind::kPaint;
}

// Whatever a driver reports.
float pressureOf(const PointerEvent& event) {
  return event.pressure >= 0 ? std::min(event.pressure, 1.f) : 1.f;
}

BrushStroke makeStroke(const BrushSettings& settings, BrushKind kind, double radius) {
  return {.kind = kind,
          .stroke = {.tool = kind == BrushKind::kErase ? StrokeTool::kErase : StrokeTool::kPaint,
                     .attribute = settings.attribute,
                     .value = kind == BrushKind::kPaint ? settings.value : std::vector<double>{},
                     .radius = radius,
                     .strength = std::clamp(settings.strength, kLeastStrength, 1.0)},
          .onlyVisible = settings.onlyVisible,
          .within = settings.within};
}

// Nothing where there is no plane, or the place lies on it.
std::optional<Eigen::Vector3d> mirrorImageOf(const Eigen::Vector3d& place, const BrushSettings& settings,
                                             double radius) {
  if (settings.symmetry == SymmetryAxis::kNone) return std::nullopt;
  const int axis = static_cast<int>(settings.symmetry) - static_cast<int>(SymmetryAxis::kX);
  const double off = place[axis] - settings.symmetryCenter[axis];
  constexpr double kOnPlane = 1e-3;  // radii
  if (std::abs(off) <= kOnPlane * radius) return std::nullopt;
  Eigen::Vector3d image = place;
  image[axis] -= 2 * off;
  return image;
}

}  // namespace

BrushResponse BrushTool::handle(const PointerEvent& event, const BrushCanvas& canvas) {
  if (adjusting_ && event.action != PointerAction::kWheel) return adjust(event);
  if (running_) {
    if (event.action == PointerAction::kMove) return goOn(event, canvas);
    if (event.action != PointerAction::kRelease || event.button != PointerButton::kLeft)
      return {.taken = true};
    BrushResponse response = goOn(event, canvas);
    response.phase = StrokePhase::kEnds;
    running_.reset();
    return response;
  }
  if (alwaysNavigates(event)) return {};
  switch (event.action) {
    case PointerAction::kPress:
    case PointerAction::kDoubleClick:
      return begin(event, canvas);
    case PointerAction::kWheel:
      stepSize(event.wheelSteps, canvas);
      return {.taken = true, .redraw = true};
    case PointerAction::kMove:
      return hover(event, canvas);
    case PointerAction::kLeave:
      return {.redraw = std::exchange(ring_, std::nullopt).has_value()};
    case PointerAction::kRelease:
      return {};
  }
  return {};
}

BrushResponse BrushTool::begin(const PointerEvent& event, const BrushCanvas& canvas) {
  const std::optional<Picked> picked = canvas.pickAt(event.px);
  if (!picked) return {};
  const double radius = radiusAt(settings_, canvas.view.pixelsPerUnit(picked->depth));
  if (!(radius > 0) || !std::isfinite(radius)) return {};
  const float pressure = pressureOf(event);
  stroke_ = makeStroke(settings_, kindOf(settings_, event.modifiers), radius);
  const DabPathOptions options{.radius = static_cast<float>(radius),
                               .spacing = static_cast<float>(std::max(kLeastSpacing, settings_.spacing)),
                               .pressureScalesRadius = settings_.pressure == PressureMapping::kSize};
  running_ = Running{DabPath(options, event.px, *picked, pressure), settings_, pressure};
  ring_ = SurfaceRing{picked->position, options.radius};

  BrushResponse response{.taken = true, .redraw = true, .phase = StrokePhase::kBegins};
  addDabs(std::array{PathDab{picked->position, pressure}}, canvas, response);
  return response;
}

BrushResponse BrushTool::goOn(const PointerEvent& event, const BrushCanvas& canvas) {
  BrushResponse response{.taken = true, .redraw = true, .phase = StrokePhase::kGoesOn};
  // A pen that is lifted reports no pressure with its release.
  if (event.action == PointerAction::kMove) running_->pressure = pressureOf(event);
  const std::vector<PathDab> path =
      running_->path.extendTo(event.px, running_->pressure, canvas.view, canvas.pickAt);
  addDabs(path, canvas, response);
  const std::optional<Picked> picked = canvas.pickAt(event.px);
  ring_ = SurfaceRing{picked ? picked->position : running_->path.lastPlace(),
                      static_cast<float>(stroke_.stroke.radius)};
  return response;
}

void BrushTool::addDabs(std::span<const PathDab> path, const BrushCanvas& canvas,
                        BrushResponse& response) const {
  const BrushSettings& settings = running_->settings;
  for (const PathDab& dab : path) {
    const auto pressure = static_cast<double>(dab.pressure);
    const double strength = settings.pressure == PressureMapping::kStrength ? pressure : 1;
    const double size =
        settings.pressure == PressureMapping::kSize ? std::max<double>(pressure, kLeastPenSize) : 1;
    const Eigen::Vector3d place =
        canvas.origin + Eigen::Vector3d(dab.position.x, dab.position.y, dab.position.z);
    response.dabs.push_back({.position = place, .pressure = strength, .size = size});
    if (const auto image = mirrorImageOf(place, settings, stroke_.stroke.radius)) {
      response.dabs.push_back({.position = *image, .pressure = strength, .size = size});
    }
  }
}

BrushResponse BrushTool::cancel() {
  if (running_) {
    running_.reset();
    return {.taken = true, .redraw = true, .phase = StrokePhase::kCancelled};
  }
  if (!adjusting_) return {};
  settings_ = std::move(adjusting_->before);
  if (ring_) ring_->radius = static_cast<float>(radiusAt(settings_, adjusting_->pixelsPerUnit));
  adjusting_.reset();
  return {.taken = true, .redraw = true};
}

BrushResponse BrushTool::hover(const PointerEvent& event, const BrushCanvas& canvas) {
  const bool had = ring_.has_value();
  ring_.reset();
  if (const std::optional<Picked> picked = canvas.pickAt(event.px)) {
    const double radius = radiusAt(settings_, canvas.view.pixelsPerUnit(picked->depth));
    ring_ = SurfaceRing{picked->position, static_cast<float>(radius)};
  }
  return {.redraw = had || ring_};
}

// Pixels that a unit covers where the brush is.
float BrushTool::sizingScale(const BrushCanvas& canvas) const {
  return canvas.view.pixelsPerUnit(ring_ ? canvas.view.toView(ring_->center).z : canvas.emptyDepth);
}

void BrushTool::setRadiusPx(double radiusPx, float pixelsPerUnit) {
  const double clamped = std::clamp(radiusPx, kLeastRadiusPx, kMostRadiusPx);
  if (settings_.radiusUnit == RadiusUnit::kPixels) {
    settings_.radiusPx = clamped;
  } else {
    settings_.radius = clamped / static_cast<double>(pixelsPerUnit);
  }
  if (ring_ && !running_) ring_->radius = static_cast<float>(radiusAt(settings_, pixelsPerUnit));
}

void BrushTool::stepSize(float steps, const BrushCanvas& canvas) {
  const float scale = sizingScale(canvas);
  if (!std::isfinite(steps) || !(scale > 0) || !std::isfinite(scale)) return;
  const double before = radiusAt(settings_, scale) * static_cast<double>(scale);
  setRadiusPx(before * std::pow(kSizeStep, static_cast<double>(steps)), scale);
}

void BrushTool::beginAdjusting(BrushAdjustment what, const glm::vec2& px, const BrushCanvas& canvas) {
  const float scale = sizingScale(canvas);
  if (what == BrushAdjustment::kNone || running_ || !(scale > 0) || !std::isfinite(scale)) return;
  adjusting_ = Adjusting{.what = what,
                         .before = settings_,
                         .px = px,
                         .radiusPx = radiusAt(settings_, scale) * static_cast<double>(scale),
                         .pixelsPerUnit = scale};
}

BrushResponse BrushTool::adjust(const PointerEvent& event) {
  BrushResponse changed{.taken = true, .redraw = true};
  if (event.action == PointerAction::kMove) {
    const double dragged = static_cast<double>(event.px.x - adjusting_->px.x);
    if (adjusting_->what == BrushAdjustment::kRadius) {
      setRadiusPx(adjusting_->radiusPx + dragged, adjusting_->pixelsPerUnit);
    } else {
      settings_.strength =
          std::clamp(adjusting_->before.strength + kStrengthPerPx * dragged, kLeastStrength, 1.0);
    }
    return changed;
  }
  if (event.action == PointerAction::kRelease && event.button == PointerButton::kLeft) confirmAdjusting();
  if (event.action == PointerAction::kPress && event.button == PointerButton::kRight) return cancel();
  return changed;
}

}  // namespace stipple
