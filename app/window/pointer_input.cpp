#include "app/window/pointer_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <utility>

namespace stipple {

namespace {

constexpr float kWheelStep = 120;  // eighths of a degree

PointerButton buttonOf(Qt::MouseButton button) {
  switch (button) {
    case Qt::LeftButton:
      return PointerButton::kLeft;
    case Qt::MiddleButton:
      return PointerButton::kMiddle;
    case Qt::RightButton:
      return PointerButton::kRight;
    default:
      return PointerButton::kNone;
  }
}

Modifiers modifiersOf(Qt::KeyboardModifiers modifiers) {
  return {.shift = modifiers.testFlag(Qt::ShiftModifier),
          .ctrl = modifiers.testFlag(Qt::ControlModifier),
          .alt = modifiers.testFlag(Qt::AltModifier)};
}

glm::vec2 pixelOf(const QPointF& position, double ratio) {
  return {static_cast<float>(position.x() * ratio), static_cast<float>(position.y() * ratio)};
}

std::optional<PointerAction> actionOf(QEvent::Type type) {
  switch (type) {
    case QEvent::MouseButtonPress:
    case QEvent::TabletPress:
      return PointerAction::kPress;
    case QEvent::MouseButtonDblClick:
      return PointerAction::kDoubleClick;
    case QEvent::MouseMove:
    case QEvent::TabletMove:
      return PointerAction::kMove;
    case QEvent::MouseButtonRelease:
    case QEvent::TabletRelease:
      return PointerAction::kRelease;
    default:
      return {};
  }
}

// Alt turns a wheel sideways in Qt.
float wheelStepsOf(const QWheelEvent& wheel) {
  const QPoint angle = wheel.angleDelta();
  return static_cast<float>(angle.y() != 0 ? angle.y() : angle.x()) / kWheelStep;
}

PointerEvent singlePointEvent(const QSinglePointEvent& event, PointerAction action, double ratio) {
  PointerEvent made{
      .action = action, .px = pixelOf(event.position(), ratio), .modifiers = modifiersOf(event.modifiers())};
  if (action != PointerAction::kMove) made.button = buttonOf(event.button());
  return made;
}

OverlayButton overlayButtonOf(PointerButton button) {
  if (button == PointerButton::kMiddle) return OverlayButton::kMiddle;
  return button == PointerButton::kRight ? OverlayButton::kRight : OverlayButton::kLeft;
}

std::optional<OverlayKey> overlayKeyOf(int key) {
  static constexpr std::pair<int, OverlayKey> kKeys[] = {{Qt::Key_Tab, OverlayKey::kTab},
                                                         {Qt::Key_Left, OverlayKey::kLeft},
                                                         {Qt::Key_Right, OverlayKey::kRight},
                                                         {Qt::Key_Up, OverlayKey::kUp},
                                                         {Qt::Key_Down, OverlayKey::kDown},
                                                         {Qt::Key_PageUp, OverlayKey::kPageUp},
                                                         {Qt::Key_PageDown, OverlayKey::kPageDown},
                                                         {Qt::Key_Home, OverlayKey::kHome},
                                                         {Qt::Key_End, OverlayKey::kEnd},
                                                         {Qt::Key_Insert, OverlayKey::kInsert},
                                                         {Qt::Key_Delete, OverlayKey::kDelete},
                                                         {Qt::Key_Backspace, OverlayKey::kBackspace},
                                                         {Qt::Key_Space, OverlayKey::kSpace},
                                                         {Qt::Key_Return, OverlayKey::kEnter},
                                                         {Qt::Key_Enter, OverlayKey::kEnter},
                                                         {Qt::Key_Escape, OverlayKey::kEscape},
                                                         {Qt::Key_A, OverlayKey::kA},
                                                         {Qt::Key_C, OverlayKey::kC},
                                                         {Qt::Key_V, OverlayKey::kV},
                                                         {Qt::Key_X, OverlayKey::kX},
                                                         {Qt::Key_Y, OverlayKey::kY},
                                                         {Qt::Key_Z, OverlayKey::kZ}};
  for (const auto& [qt, ours] : kKeys) {
    if (qt == key) return ours;
  }
  return {};
}

}  // namespace

std::optional<PointerEvent> pointerEventOf(const QEvent& event, double ratio) {
  if (event.type() == QEvent::Wheel) {
    const auto& wheel = static_cast<const QWheelEvent&>(event);
    return PointerEvent{.action = PointerAction::kWheel,
                        .px = pixelOf(wheel.position(), ratio),
                        .modifiers = modifiersOf(wheel.modifiers()),
                        .wheelSteps = wheelStepsOf(wheel)};
  }
  if (event.type() == QEvent::Leave) return PointerEvent{.action = PointerAction::kLeave};
  const auto action = actionOf(event.type());
  if (!action) return {};
  PointerEvent made = singlePointEvent(static_cast<const QSinglePointEvent&>(event), *action, ratio);
  const bool isPen = event.type() == QEvent::TabletPress || event.type() == QEvent::TabletMove ||
                     event.type() == QEvent::TabletRelease;
  if (isPen) made.pressure = static_cast<float>(static_cast<const QTabletEvent&>(event).pressure());
  return made;
}

void feedOverlay(OverlayContext& overlay, const PointerEvent& event) {
  const Modifiers& held = event.modifiers;
  overlay.setModifiers({.ctrl = held.ctrl, .shift = held.shift, .alt = held.alt});
  if (event.action == PointerAction::kLeave) return overlay.leaveMouse();
  overlay.moveMouse(event.px);
  if (event.action == PointerAction::kWheel) overlay.turnWheel(event.wheelSteps);
  const bool isDown = event.action == PointerAction::kPress || event.action == PointerAction::kDoubleClick;
  if (isDown || event.action == PointerAction::kRelease)
    overlay.setButton(overlayButtonOf(event.button), isDown);
}

void feedOverlay(OverlayContext& overlay, const QKeyEvent& event) {
  const bool isDown = event.type() == QEvent::KeyPress;
  if (const auto key = overlayKeyOf(event.key())) overlay.setKey(*key, isDown);
  if (!isDown) return;
  for (const char32_t character : event.text().toUcs4()) {
    if (character >= 32) overlay.typeCharacter(character);
  }
}

}  // namespace stipple
