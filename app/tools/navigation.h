#pragma once

#include <optional>

#include "app/tools/orbit_camera.h"
#include "app/tools/pick_at.h"
#include "app/tools/pointer_event.h"

namespace stipple {

/// True for what moves the camera whatever tool is at hand: Alt and left, middle, right, the bare wheel. Of
/// drags, their presses.
bool alwaysNavigates(const PointerEvent& event);

/// Turns events into moves of a camera: left drags orbit; middle, right and shift-left drags pan; the wheel
/// zooms toward what is under it; a double click makes what it hits the pivot. Alt and left orbits too.
class Navigation {
 public:
  /// Returns whether the camera changed.
  bool handle(const PointerEvent& event, OrbitCamera& camera, const PictureSize& size, const PickAt& pickAt);
  bool isDragging() const { return drag_ != Drag::kNone; }
  /// Ends a drag where it is, as when the window loses the pointer.
  void release() { drag_ = Drag::kNone; }

 private:
  enum class Drag { kNone, kOrbit, kPan };

  void press(const PointerEvent& event, const OrbitCamera& camera, const PictureSize& size,
             const PickAt& pickAt);
  bool move(const PointerEvent& event, OrbitCamera& camera, const PictureSize& size);
  bool zoom(const PointerEvent& event, OrbitCamera& camera, const PictureSize& size, const PickAt& pickAt);

  Drag drag_ = Drag::kNone;
  PointerButton button_ = PointerButton::kNone;  // that began the drag
  glm::vec2 lastPx_{};
  float depth_ = 0;                       // of what is dragged along
  std::optional<glm::vec3> wheelTarget_;  // what the wheel zooms at; the picture may lag behind the camera
};

/// Views by number keys: 1 front, 3 right, 7 top, with ctrl the opposite; 5 changes the projection. False for
/// others.
bool applyViewKey(int digit, bool ctrl, OrbitCamera& camera);

}  // namespace stipple
