// The part of the view controller that fills and follows the overlay.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <QMessageBox>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/tools/inspection_drawing.h"
#include "app/tools/measure.h"
#include "app/tools/view_selection.h"
#include "app/window/view_controller.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

constexpr int kRingPoints = 64;

std::optional<glm::vec2> onScreen(const View& view, const glm::vec3& place) {
  const glm::vec3 inView = view.toView(place);
  if (inView.z <= view.nearDepth) return {};
  return view.toPixels(inView);
}

// A difference across a pixel, towards the side whose depth is nearer: not across an edge of the surface.
std::optional<glm::vec3> pickedSlope(const PickAt& pickAt, const glm::vec2& px, const glm::vec2& step,
                                     const Picked& center) {
  const auto before = pickAt(px - step), after = pickAt(px + step);
  const auto jump = [&](const std::optional<Picked>& picked) {
    return picked ? std::abs(picked->depth - center.depth) : std::numeric_limits<float>::infinity();
  };
  if (!before && !after) return {};
  return jump(after) <= jump(before) ? after->position - center.position : center.position - before->position;
}

// The normal of what the picture shows around a pixel.
glm::vec3 pickedNormal(const PickAt& pickAt, const glm::vec2& px, const View& view, const glm::vec3& center) {
  const glm::vec3 towardsEye = glm::normalize(view.eye - center);
  const auto here = pickAt(px);
  if (!here) return towardsEye;
  const auto right = pickedSlope(pickAt, px, {6, 0}, *here), down = pickedSlope(pickAt, px, {0, 6}, *here);
  if (!right || !down) return towardsEye;
  const glm::vec3 normal = glm::cross(*right, *down);
  const float length = glm::length(normal);
  if (!(length > 0)) return towardsEye;
  const glm::vec3 unit = normal / length;
  return glm::dot(unit, towardsEye) < 0 ? -unit : unit;
}

ScreenLine ringLine(const View& view, const glm::vec3& center, const glm::vec3& normal, float radius) {
  const glm::vec3 other = std::abs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 u = glm::normalize(glm::cross(normal, other)), v = glm::cross(normal, u);
  ScreenLine ring{.points = {}, .isClosed = true};
  for (int i = 0; i < kRingPoints; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / kRingPoints;
    if (const auto px = onScreen(view, center + radius * (std::cos(angle) * u + std::sin(angle) * v)))
      ring.points.push_back(*px);
  }
  return ring;
}

ScreenLine lineOfOutline(const std::vector<glm::vec2>& outline, bool isRectangle) {
  if (!isRectangle) return {.points = outline, .isClosed = true};
  const glm::vec2 a = outline.front(), b = outline.back();
  return {.points = {a, {b.x, a.y}, b, {a.x, b.y}}, .isClosed = true};
}

}  // namespace

std::vector<ScreenLine> ViewController::overlayLines() const {
  std::vector<ScreenLine> lines;
  const auto notes = viewport_->notes();
  if (!notes || !workbench_.current()) return lines;
  if (isBrush() && brush_.ring() && mouse_) {
    const SurfaceRing& ring = *brush_.ring();
    const PickAt pickAt = [this](const glm::vec2& px) { return viewport_->pickAt(px); };
    const glm::vec3 normal = pickedNormal(pickAt, *mouse_, notes->view, ring.center);
    lines.push_back(ringLine(notes->view, ring.center, normal, ring.radius));
    // Where the brush is half as strong: (1 - t^2)^2 = 1/2.
    if (lines.back().points.size() > 2)
      lines.push_back(ringLine(notes->view, ring.center, normal, 0.541f * ring.radius));
  }
  if (!outline_.empty()) lines.push_back(lineOfOutline(outline_, tool_ == Tool::kRectangle));
  const auto add = [&](const std::vector<glm::vec3>& places, const Rgba8& color) {
    ScreenLine line{.points = {}, .color = color};
    for (const glm::vec3& place : places) {
      if (const auto px = onScreen(notes->view, place)) line.points.push_back(*px);
    }
    lines.push_back(std::move(line));
  };
  if (measured_.size() == 2) {
    add({measured_[0].position, measured_[1].position}, {255, 255, 255, 255});
    add(measuredPath_, {255, 152, 26, 255});
  }
  for (const ColoredSegment& segment : inspectedLines_) add({segment.from, segment.to}, segment.color);
  std::erase_if(lines, [](const ScreenLine& line) { return line.points.size() < 2; });
  return lines;
}

std::vector<ScreenText> ViewController::overlayTexts() const {
  std::vector<ScreenText> texts;
  const auto notes = viewport_->notes();
  const auto add = [&](const glm::vec3& place, const std::string& text) {
    const auto px = notes ? onScreen(notes->view, place) : std::nullopt;
    if (px && !text.empty()) texts.push_back({*px, text});
  };
  if (!measured_.empty()) add(measured_.back().position, measuredText_);
  if (inspected_) add(inspected_->position, inspectedText_);
  return texts;
}

void ViewController::measureTo(const Picked& picked) {
  if (measured_.size() == 2) measured_.clear();
  measured_.push_back(picked);
  measureAgain();
}

// Along the surface too, once distances are known.
void ViewController::measureAgain() {
  const OpenScan* scan = workbench_.current();
  measuredPath_.clear();
  measuredText_.clear();
  if (!scan || measured_.size() < 2) return;
  const glm::vec3 from = measured_[0].position, to = measured_[1].position;
  measuredText_ = fmt::format("{:.5g}", glm::length(to - from));
  viewport_->widget().update();
  if (!scan->hasDistance()) return askForDistance();
  const Measurement found = measure(*scan->distance, from, to);
  measuredPath_ = found.path;
  if (found.alongSurface) measuredText_ += fmt::format(", along the surface {:.5g}", *found.alongSurface);
}

void ViewController::inspectAt(const Picked& picked) {
  const OpenScan& scan = *workbench_.current();
  const auto notes = viewport_->notes();
  const PointSet& points = scan.document.points();
  const std::vector<float> depth = viewport_->depthPicture();
  const SeenPoints seen{.positions = points.positions(),
                        .view = notes->view,
                        .depth = depth,
                        .tolerance = visibilityTolerance(scan.extent.spacing)};
  constexpr float kReach = 24;
  const auto row = findClicked(seen, notes->view.toPixels(notes->view.toView(picked.position)), kReach);
  if (!row) return;
  try {
    const PointInspection inspection = inspectPoint(points, *row);
    inspected_ = picked;
    inspected_->position = {inspection.position.x(), inspection.position.y(), inspection.position.z()};
    inspectedLines_ = segmentsOf(inspection, points);
    inspectedText_ = fmt::format("{}", fmt::join(linesOf(inspection), "\n"));
  } catch (const Error& error) {
    workbench_.say(QString::fromStdString(error.what()));
  }
}

void ViewController::forgetPlaces() {
  measured_.clear();
  measuredPath_.clear();
  inspected_.reset();
  inspectedLines_.clear();
}

void ViewController::fillOverlay() {
  OpenScan* scan = workbench_.current();
  if (scan && isBrush())
    overlayView_.showBrush(brush_.settings(), tool_ == Tool::kSelect, *scan);
  else
    overlayView_.hideBrush();
  overlayView_.showProcess(workbench_.process());
  overlayView_.showLegend(scan);
  overlayView_.showStatistics(scan, viewport_->notes(), viewport_->backend());
}

ViewController::OverlayStep ViewController::stepOverlay() {
  fillOverlay();
  const PictureSize size = pictureSize();
  const auto seconds = static_cast<float>(overlayClock_.restart()) / 1000;
  overlayContext_.beginFrame({size.width, size.height}, std::max(seconds, 1e-4f));
  const OverlayActions actions = overlayView_.draw(overlayLines(), overlayTexts());
  return {actions, overlayContext_.endFrame()};
}

const ImDrawData& ViewController::drawOverlay() {
  const auto [actions, drawing] = stepOverlay();
  // What the user did acts after the picture is painted, not within.
  QMetaObject::invokeMethod(
      this, [this, actions = actions] { applyOverlay(actions); }, Qt::QueuedConnection);
  if (overlayContext_.hasPendingInput() || overlayContext_.hasHiddenPanels() || overlayView_.isAnimated())
    QTimer::singleShot(30, this, [this] { viewport_->widget().update(); });
  return drawing;
}

void ViewController::applyOverlay(const OverlayActions& actions) {
  OpenScan* scan = workbench_.current();
  if (actions.curve.pause) workbench_.pause();
  if (actions.curve.resume) workbench_.resume();
  if (actions.curve.step) workbench_.stepOnce();
  if (actions.curve.stop) workbench_.stop();
  if (actions.curve.cancel) workbench_.cancel();
  if (actions.cards.dismiss)
    std::erase_if(overlayView_.cards,
                  [&](const HintCard& card) { return card.id == *actions.cards.dismiss; });
  if (actions.cards.start) emit cardStarted(QString::fromStdString(*actions.cards.start));
  if (actions.message.showDetails)
    QMessageBox(QMessageBox::NoIcon, tr("Details"), QString::fromStdString(overlayView_.details()),
                QMessageBox::Ok, &viewport_->widget())
        .exec();
  if (!scan || !isBrush()) return;
  if (actions.brush.tool) {
    static constexpr Tool kTools[] = {Tool::kPaint, Tool::kErase, Tool::kSmooth, Tool::kSelect};
    return setTool(kTools[static_cast<int>(*actions.brush.tool)]);
  }
  BrushSettings settings = brush_.settings();
  settings.symmetryCenter = scan->document.points().origin() + Eigen::Vector3d(scan->extent.sphere.center.x,
                                                                               scan->extent.sphere.center.y,
                                                                               scan->extent.sphere.center.z);
  if (!applyBrushActions(actions.brush, overlayView_.paintedAttributes(), *scan, settings)) return;
  const bool isOther = actions.brush.attribute.has_value();
  setBrush(settings);
  if (isOther && tool_ != Tool::kSelect) {
    scan->look.colors = ColorSource{.attribute = settings.attribute == "color" ? "" : settings.attribute};
    relook();
  }
}

}  // namespace stipple
