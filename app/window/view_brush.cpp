// The part of the view controller that paints.
#include <QWidget>
#include <cmath>

#include "app/tools/view_selection.h"
#include "app/window/view_controller.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

// Where the picture shows nothing nearer.
bool isSeen(const glm::vec3& place, const View& view, const std::vector<float>& depth, float tolerance) {
  const glm::vec3 inView = view.toView(place);
  if (inView.z <= view.nearDepth) return false;
  const glm::vec2 px = view.toPixels(inView);
  const auto x = static_cast<int>(std::floor(px.x)), y = static_cast<int>(std::floor(px.y));
  if (x < 0 || y < 0 || x >= view.width || y >= view.height) return false;
  return inView.z <= depth[static_cast<std::size_t>(y) * view.width + x] + tolerance;
}

}  // namespace

void ViewController::paintAttribute(const std::string& attribute, std::vector<double> value, PaintKind kind) {
  paintSettings_.attribute = attribute;
  paintSettings_.value = std::move(value);
  maskAttribute_ = kind == PaintKind::kMask ? attribute : "";
  setTool(Tool::kPaint);
  showPainted(attribute);
}

// What is painted is shown, as soon as it is there; masks over the colors that they are about.
void ViewController::showPainted(const std::string& attribute) {
  OpenScan* scan = workbench_.current();
  if (!scan) return;
  Look& look = scan->look;
  const bool isMask = attribute == maskAttribute_ && !attribute.empty();
  const std::string shown = isMask ? look.colors.attribute : attribute == "color" ? "" : attribute;
  const std::string marked = isMask ? attribute : "";
  if (look.colors.attribute == shown && look.marked == marked) return;
  if (look.colors.attribute != shown) look.colors = ColorSource{.attribute = shown};
  look.marked = marked;
  relook();
}

void ViewController::setBrush(const BrushSettings& settings) {
  BrushSettings kept = settings;
  if (tool_ == Tool::kSelect) {
    kept.attribute = paintSettings_.attribute;
    kept.value = paintSettings_.value;
  }
  paintSettings_ = kept;
  brush_.set(settings);
  viewport_->widget().update();
}

void ViewController::askForDistance() {
  const OpenScan* scan = workbench_.current();
  if (scan && !scan->hasDistance()) workbench_.prepareDistance();
}

BrushCanvas ViewController::canvas(const PickAt& pickAt) const {
  static const View kNone;
  const auto notes = viewport_->notes();
  const OpenScan& scan = *workbench_.current();
  shownView_ = notes ? notes->view : kNone;
  return {.view = shownView_,
          .pickAt = pickAt,
          .origin = scan.document.points().origin(),
          .emptyDepth = scan.camera.pivotDepth()};
}

bool ViewController::handleBrush(const PointerEvent& event) {
  const PickAt pickAt = picker();
  const BrushResponse response = brush_.handle(event, canvas(pickAt));
  if (response.phase != StrokePhase::kNone) followStroke(response);
  if (response.redraw) viewport_->widget().update();
  if (response.taken) {
    paintSettings_.radius = brush_.settings().radius;
    paintSettings_.radiusPx = brush_.settings().radiusPx;
    paintSettings_.strength = brush_.settings().strength;
  }
  return response.taken;
}

void ViewController::beginPainting() {
  OpenScan& scan = *workbench_.current();
  if (!scan.hasDistance()) {
    askForDistance();
    throw InvalidInput("The brush is being prepared; paint again in a moment");
  }
  const BrushStroke& begun = brush_.stroke();
  Stroke stroke = begun.stroke;
  stroke.tool = begun.kind == BrushKind::kErase    ? StrokeTool::kErase
                : begun.kind == BrushKind::kSmooth ? StrokeTool::kSmooth
                                                   : StrokeTool::kPaint;
  stroke.within = begun.within;
  PointFilter filter;
  if (begun.onlyVisible) {
    auto depth = std::make_shared<const std::vector<float>>(viewport_->depthPicture());
    const View view = viewport_->notes()->view;
    filter = [&scan, depth, view, tolerance = visibilityTolerance(scan.extent.spacing)](Index point) {
      const Eigen::Vector3f& p = scan.document.points().positions()[point];
      return isSeen({p.x(), p.y(), p.z()}, view, *depth, tolerance);
    };
  }
  painting_.begin(scan.document, scan.distance, stroke, std::move(filter));
  if (tool_ != Tool::kSelect) showPainted(stroke.attribute);
}

void ViewController::followStroke(const BrushResponse& response) {
  bool isLaidDown = false;
  Document& document = workbench_.current()->document;
  try {
    if (response.phase == StrokePhase::kBegins) beginPainting();
    if (painting_.isActive()) painting_.lay(document, response.dabs);
    if (painting_.isActive() && response.phase == StrokePhase::kEnds) {
      painting_.end(document);
      isLaidDown = true;
    }
    if (painting_.isActive() && response.phase == StrokePhase::kCancelled) painting_.cancel(document);
  } catch (const Error& error) {
    if (painting_.isActive()) painting_.cancel(document);
    brush_.cancel();
    workbench_.say(QString("%1.").arg(QString::fromStdString(error.what())));
  }
  const bool isOver = response.phase == StrokePhase::kEnds || response.phase == StrokePhase::kCancelled;
  workbench_.tellPointsChanged(isOver ? Workbench::Change::kDone : Workbench::Change::kGoesOn);
  if (isLaidDown) emit strokeEnded(brush_.stroke().stroke.attribute);
}

// What is painted so far stays; the mouse may still be down.
void ViewController::endStroke() {
  brush_.cancel();
  navigation_.release();
  if (!painting_.isActive()) return;
  painting_.end(workbench_.current()->document);
  workbench_.tellPointsChanged();
}

}  // namespace stipple
