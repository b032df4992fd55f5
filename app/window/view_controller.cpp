#include "app/window/view_controller.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "app/tools/view_selection.h"
#include "app/window/pointer_input.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

constexpr const char* kSelectionTitle = "Select";

bool isPress(const PointerEvent& event) {
  return event.action == PointerAction::kPress || event.action == PointerAction::kDoubleClick;
}

}  // namespace

ViewController::ViewController(Workbench& workbench, std::unique_ptr<Viewport> viewport, QObject* parent)
    : QObject(parent), workbench_(workbench), viewport_(std::move(viewport)) {
  viewport_->overlayContext = &overlayContext_;
  viewport_->overlay = [this]() -> const ImDrawData& { return drawOverlay(); };
  viewport_->pictureChanged = [this] {
    if (const auto notes = viewport_->notes()) overlayView_.noteFrame(*notes);
    emit pictureChanged();
  };
  viewport_->failed = [this](const std::string& sentence) {
    workbench_.say(QString::fromStdString(sentence));
  };
  viewport_->widget().installEventFilter(this);
  connect(&workbench, &Workbench::leavingCurrent, this, &ViewController::endStroke);
  connect(&workbench, &Workbench::currentChanged, this, &ViewController::showCurrent);
  connect(&workbench, &Workbench::pointsChanged, this, &ViewController::followPoints);
  connect(&workbench, &Workbench::pointsTouched, this, &ViewController::followPoints);
  connect(&workbench, &Workbench::previewChanged, this, &ViewController::followPreview);
  connect(&workbench, &Workbench::previewEnded, this, &ViewController::relook);
  connect(&workbench, &Workbench::processChanged, &viewport_->widget(), qOverload<>(&QWidget::update));
  connect(&workbench, &Workbench::distanceReady, this, &ViewController::measureAgain);
  connect(&workbench, &Workbench::said, this, [this](const QString& sentence, const QString& details) {
    overlayView_.say(sentence.toStdString(), details.toStdString());
    viewport_->widget().update();
  });
  paintSettings_.radiusPx *= viewport_->widget().devicePixelRatioF();
  brush_.set(paintSettings_);
  overlayClock_.start();
}

ViewController::~ViewController() {
  viewport_->overlay = nullptr;
  viewport_->widget().removeEventFilter(this);
}

PictureSize ViewController::pictureSize() const {
  const QWidget& widget = viewport_->widget();
  const double ratio = widget.devicePixelRatioF();
  return {static_cast<int>(std::lround(widget.width() * ratio)),
          static_cast<int>(std::lround(widget.height() * ratio))};
}

PickAt ViewController::picker() {
  return [this](const glm::vec2& px) { return viewport_->pickAt(px); };
}

void ViewController::postView() {
  const OpenScan* scan = workbench_.current();
  const PictureSize size = pictureSize();
  if (!scan || size.width < 1 || size.height < 1) return;
  viewport_->setView(scan->camera.view(size));
}

// Another scan, or the first one.
void ViewController::showCurrent() {
  forgetPlaces();
  outline_.clear();
  OpenScan* scan = workbench_.current();
  if (!scan) {
    DisplayFollower nothing;
    viewport_->post(nothing.show(PointSet(), {}), 0);
    return;
  }
  viewport_->post(scan->follower.show(scan->document.points(), scan->look), scan->document.revision());
  scan->shownRevision = scan->document.revision();
  postView();
  if (isBrush()) askForDistance();
}

void ViewController::followPoints() {
  OpenScan* scan = workbench_.current();
  if (!scan) return;
  const DocumentChange change = scan->document.changedSince(scan->shownRevision);
  const bool areOthers = change.everything;
  scan->shownRevision = scan->document.revision();
  try {
    if (auto shown = scan->follower.follow(scan->document.points(), change))
      viewport_->post(std::move(*shown), scan->shownRevision);
  } catch (const Error& error) {
    workbench_.say(QString::fromStdString(error.what()));
  }
  if (areOthers) {
    scan->extent = measureExtent(scan->document.points());
    scan->camera.setModel(scan->extent.sphere);
    if (isBrush()) askForDistance();
  }
}

void ViewController::followPreview(const PointSet& state) {
  OpenScan* scan = workbench_.processScan();
  if (!scan || scan != workbench_.current()) return;
  try {
    if (auto shown = scan->follower.preview(state)) viewport_->post(std::move(*shown), scan->shownRevision);
  } catch (const Error&) {
    // A state that cannot be shown is passed over.
  }
}

void ViewController::relook() {
  OpenScan* scan = workbench_.current();
  if (!scan) return;
  try {
    viewport_->post(scan->follower.restyle(scan->document.points(), scan->look), scan->document.revision());
  } catch (const Error& error) {
    workbench_.say(QString::fromStdString(error.what()));
  }
}

void ViewController::setTool(Tool tool) {
  if (painting_.isActive()) return;
  if (tool != tool_) forgetPlaces();
  if (tool != Tool::kOrbit) overlayView_.cards.clear();
  tool_ = tool;
  outline_.clear();
  BrushSettings settings = paintSettings_;
  if (tool == Tool::kSelect) {
    settings.attribute = kSelection;
    settings.value = {1};
  }
  settings.kind = tool == Tool::kErase    ? BrushKind::kErase
                  : tool == Tool::kSmooth ? BrushKind::kSmooth
                                          : BrushKind::kPaint;
  brush_.set(settings);
  if (isBrush()) askForDistance();
  updateCursor();
  viewport_->widget().setFocus();  // for the keys of the tool
  viewport_->widget().update();
  emit toolChanged();
}

void ViewController::updateCursor() {
  viewport_->widget().setCursor(tool_ == Tool::kOrbit ? Qt::ArrowCursor : Qt::CrossCursor);
}

void ViewController::frameModel() {
  if (OpenScan* scan = workbench_.current()) scan->camera.frame(scan->extent.sphere);
  postView();
}

void ViewController::applyViewKey(int digit, bool opposite) {
  if (OpenScan* scan = workbench_.current()) stipple::applyViewKey(digit, opposite, scan->camera);
  postView();
}

void ViewController::toggleProjection() {
  if (OpenScan* scan = workbench_.current()) scan->camera.toggleProjection();
  postView();
}

void ViewController::setUpAxis(UpAxis up) {
  if (OpenScan* scan = workbench_.current()) scan->camera.setUpAxis(up);
  postView();
}

void ViewController::setMode(SplatMode mode) {
  appearance_.mode = mode;
  viewport_->setAppearance(appearance_);
}

void ViewController::setTheme(Theme theme) {
  const QColor color = colorsOf(theme).viewport;
  appearance_.background =
      Rgba8{static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue()), 255};
  OverlayLook look = overlayContext_.look();
  look.theme = theme == Theme::kDark ? OverlayTheme::kDark : OverlayTheme::kLight;
  overlayContext_.setLook(look);
  viewport_->setAppearance(appearance_);
}

void ViewController::showStatistics(bool isShown) {
  overlayView_.showsStatistics = isShown;
  viewport_->widget().update();
}

bool ViewController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) {
    OverlayLook look = overlayContext_.look();
    look.scale = static_cast<float>(viewport_->widget().devicePixelRatioF());
    if (!(look == overlayContext_.look())) overlayContext_.setLook(look);
    postView();
    return false;
  }
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) {
    return handleKey(static_cast<const QKeyEvent&>(*event));
  }
  if (event->type() == QEvent::ShortcutOverride) {
    // Typing into a field of the overlay is no command.
    if (overlayContext_.wantsKeyboard()) event->accept();
    return overlayContext_.wantsKeyboard();
  }
  if (const auto pointer = pointerEventOf(*event, viewport_->widget().devicePixelRatioF())) {
    if (isPress(*pointer)) viewport_->widget().setFocus();
    const bool isTaken = handlePointer(*pointer);
    if (event->type() != QEvent::Leave) event->accept();
    return isTaken;
  }
  return QObject::eventFilter(watched, event);
}

bool ViewController::handlePointer(const PointerEvent& event) {
  if (event.action == PointerAction::kLeave)
    mouse_.reset();
  else
    mouse_ = event.px;
  feedOverlay(overlayContext_, event);
  const bool isWorking = painting_.isActive() || navigation_.isDragging() || !outline_.empty();
  if (overlayContext_.wantsMouse() && !isWorking) {
    // What is clicked acts before anything else is done, however long a picture takes.
    if (event.action != PointerAction::kMove) applyOverlay(stepOverlay().actions);
    viewport_->widget().update();
    return true;
  }
  if (isBrush() || overlayContext_.hasPendingInput()) viewport_->widget().update();
  if (!workbench_.current()) return true;
  if (isBrush() && !navigation_.isDragging() && handleBrush(event)) return true;
  if ((tool_ == Tool::kRectangle || tool_ == Tool::kLasso) && handleOutline(event)) return true;
  if ((tool_ == Tool::kMeasure || tool_ == Tool::kInspect) && handleClickTool(event)) return true;
  navigate(event);
  return true;
}

void ViewController::navigate(const PointerEvent& event) {
  OpenScan& scan = *workbench_.current();
  if (navigation_.handle(event, scan.camera, pictureSize(), picker())) postView();
}

bool ViewController::handleOutline(const PointerEvent& event) {
  if (outline_.empty()) {
    if (!isPress(event) || event.button != PointerButton::kLeft || event.modifiers.alt) return false;
    outline_ = {event.px, event.px};
    outlineModifiers_ = event.modifiers;
    return true;
  }
  if (event.action == PointerAction::kMove) {
    if (tool_ == Tool::kRectangle)
      outline_.back() = event.px;
    else if (glm::length(event.px - outline_.back()) >= 2)
      outline_.push_back(event.px);
    viewport_->widget().update();
  }
  if (event.action == PointerAction::kRelease && event.button == PointerButton::kLeft) selectOutline();
  return true;
}

void ViewController::selectOutline() {
  const std::vector<glm::vec2> outline = std::exchange(outline_, {});
  const OpenScan& scan = *workbench_.current();
  const auto notes = viewport_->notes();
  viewport_->widget().update();
  if (!notes) return;
  const PointSet& points = scan.document.points();
  const std::vector<float> depth = viewport_->depthPicture();
  const SeenPoints seen{.positions = points.positions(),
                        .view = notes->view,
                        .depth = depth,
                        .tolerance = visibilityTolerance(scan.extent.spacing)};
  std::vector<Index> rows;
  if (glm::length(outline.back() - outline.front()) < 3 && outline.size() == 2) {
    if (const auto row = findClicked(seen, outline.front())) rows.push_back(*row);
  } else if (tool_ == Tool::kRectangle) {
    rows = findInRectangle(seen, {.corner = outline.front(), .opposite = outline.back()});
  } else {
    rows = findInLasso(seen, outline);
  }
  const SelectionMask selection = combine(selectionOf(points), rows, combineFor(outlineModifiers_));
  workbench_.commit(kSelectionTitle, withSelection(points, selection));
}

void ViewController::selectByValue(const std::string& attribute, double low, double high) {
  const OpenScan* scan = workbench_.current();
  if (!scan) return;
  const PointSet& points = scan->document.points();
  const std::vector<Index> rows = findInRange(points, attribute, low, high);
  const Qt::KeyboardModifiers keys = QGuiApplication::keyboardModifiers();
  const Modifiers held{.shift = keys.testFlag(Qt::ShiftModifier), .ctrl = keys.testFlag(Qt::ControlModifier)};
  workbench_.commit("Select by value",
                    withSelection(points, combine(selectionOf(points), rows, combineFor(held))));
}

void ViewController::changeSelection(SelectionChange change) {
  const OpenScan* scan = workbench_.current();
  if (!scan) return;
  const PointSet& points = scan->document.points();
  const auto commit = [&](const char* title, const SelectionMask& selection) {
    workbench_.commit(title, withSelection(points, selection));
  };
  switch (change) {
    case SelectionChange::kAll:
      return commit("Select all", everything(points.size()));
    case SelectionChange::kNone:
      return commit("Select nothing", nothing(points.size()));
    case SelectionChange::kInvert:
      return commit("Invert selection", invert(selectionOf(points)));
    case SelectionChange::kGrow:
      return workbench_.widenSelection(Workbench::Widening::kGrow);
    case SelectionChange::kShrink:
      return workbench_.widenSelection(Workbench::Widening::kShrink);
  }
}

bool ViewController::handleClickTool(const PointerEvent& event) {
  if (event.action != PointerAction::kPress || event.button != PointerButton::kLeft || event.modifiers.alt)
    return false;
  const auto picked = viewport_->pickAt(event.px);
  if (!picked) return false;
  if (tool_ == Tool::kMeasure)
    measureTo(*picked);
  else
    inspectAt(*picked);
  viewport_->widget().update();
  return true;
}

bool ViewController::escape() {
  OpenScan* scan = workbench_.current();
  if (!outline_.empty()) {
    outline_.clear();
  } else if (painting_.isActive()) {
    followStroke(brush_.cancel());
  } else if (brush_.adjusting() != BrushAdjustment::kNone) {
    brush_.cancel();
  } else if (!measured_.empty() || inspected_) {
    forgetPlaces();
  } else if (workbench_.isRunning() && scan) {
    workbench_.cancel();
  } else {
    return false;
  }
  viewport_->widget().update();
  return true;
}

bool ViewController::handleKey(const QKeyEvent& event) {
  feedOverlay(overlayContext_, event);
  if (overlayContext_.wantsKeyboard()) {
    viewport_->widget().update();
    return true;
  }
  if (event.type() != QEvent::KeyPress) return false;
  if (event.key() == Qt::Key_Escape) return escape();
  if (!workbench_.current()) return false;
  const PickAt pickAt = picker();
  if (event.key() == Qt::Key_BracketLeft || event.key() == Qt::Key_BracketRight) {
    brush_.stepSize(event.key() == Qt::Key_BracketLeft ? -1 : 1, canvas(pickAt));
    setBrush(brush_.settings());
    return true;
  }
  if (event.key() == Qt::Key_F) {
    if (!isBrush()) {
      frameModel();
    } else if (mouse_) {
      const bool isStrength = event.modifiers().testFlag(Qt::ShiftModifier);
      brush_.beginAdjusting(isStrength ? BrushAdjustment::kStrength : BrushAdjustment::kRadius, *mouse_,
                            canvas(pickAt));
    }
    return true;
  }
  return false;
}

}  // namespace stipple
