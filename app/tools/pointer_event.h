#pragma once

#include <glm/vec2.hpp>

namespace stipple {

enum class PointerAction { kPress, kMove, kRelease, kDoubleClick, kWheel, kLeave };
enum class PointerButton { kNone, kLeft, kMiddle, kRight };

struct Modifiers {
  bool shift = false, ctrl = false, alt = false;
};

/// What a mouse, a pen or a wheel did over the view. A double click comes in place of the second press.
struct PointerEvent {
  PointerAction action = PointerAction::kMove;
  glm::vec2 px{};                               ///< pixels of the picture, y from the top
  PointerButton button = PointerButton::kNone;  ///< that was pressed or released; kNone for other actions
  Modifiers modifiers = {};
  float pressure = 1;    ///< of a pen, in [0, 1]; 1 for a mouse
  float wheelSteps = 0;  ///< > 0: turned away from the user; parts of a step on touch pads
};

}  // namespace stipple
