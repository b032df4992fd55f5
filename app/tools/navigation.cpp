#include "app/tools/navigation.h"

#include <glm/geometric.hpp>

namespace stipple {

namespace {

// Depth of what is seen at a pixel, as the camera stands now.
float depthAt(const glm::vec2& px, const OrbitCamera& camera, const PictureSize& size, const PickAt& pickAt) {
  const std::optional<Picked> picked = pickAt ? pickAt(px) : std::nullopt;
  return picked ? camera.view(size).toView(picked->position).z : camera.pivotDepth();
}

bool isUnder(const glm::vec2& px, const glm::vec3& place, const View& view) {
  const glm::vec3 inView = view.toView(place);
  return inView.z > view.nearDepth && glm::distance(view.toPixels(inView), px) < 1.5f;
}

}  // namespace

bool alwaysNavigates(const PointerEvent& event) {
  if (event.action == PointerAction::kWheel) return !event.modifiers.alt;
  if (event.action != PointerAction::kPress && event.action != PointerAction::kDoubleClick) return false;
  return event.button != PointerButton::kLeft || event.modifiers.alt;
}

bool Navigation::handle(const PointerEvent& event, OrbitCamera& camera, const PictureSize& size,
                        const PickAt& pickAt) {
  if (event.action != PointerAction::kWheel) wheelTarget_.reset();
  switch (event.action) {
    case PointerAction::kPress:
      press(event, camera, size, pickAt);
      return false;
    case PointerAction::kMove:
      return move(event, camera, size);
    case PointerAction::kRelease:
      if (event.button == button_) release();
      return false;
    case PointerAction::kDoubleClick: {
      if (event.button != PointerButton::kLeft || !pickAt) return false;
      const std::optional<Picked> picked = pickAt(event.px);
      return picked && camera.setPivot(picked->position);
    }
    case PointerAction::kWheel:
      return zoom(event, camera, size, pickAt);
    case PointerAction::kLeave:
      return false;  // a drag goes on outside of the window
  }
  return false;
}

void Navigation::press(const PointerEvent& event, const OrbitCamera& camera, const PictureSize& size,
                       const PickAt& pickAt) {
  if (isDragging()) return;
  const bool orbits = event.button == PointerButton::kLeft && (event.modifiers.alt || !event.modifiers.shift);
  drag_ = orbits ? Drag::kOrbit : Drag::kPan;
  button_ = event.button;
  lastPx_ = event.px;
  if (drag_ == Drag::kPan) depth_ = depthAt(event.px, camera, size, pickAt);
}

bool Navigation::move(const PointerEvent& event, OrbitCamera& camera, const PictureSize& size) {
  if (!isDragging() || event.px == lastPx_) return false;
  if (drag_ == Drag::kOrbit) {
    camera.orbit(event.px - lastPx_, size);
  } else {
    camera.pan(lastPx_, event.px, depth_, size);
  }
  lastPx_ = event.px;
  return true;
}

bool Navigation::zoom(const PointerEvent& event, OrbitCamera& camera, const PictureSize& size,
                      const PickAt& pickAt) {
  if (event.wheelSteps == 0) return false;
  if (!wheelTarget_ || !isUnder(event.px, *wheelTarget_, camera.view(size))) {
    const View view = camera.view(size);
    const float depth = depthAt(event.px, camera, size, pickAt);
    wheelTarget_ = view.toWorld(view.fromPixels(event.px, depth));
  }
  const float depth = camera.view(size).toView(*wheelTarget_).z;
  camera.zoomToward(event.px, depth, event.wheelSteps, size);
  return true;
}

bool applyViewKey(int digit, bool ctrl, OrbitCamera& camera) {
  switch (digit) {
    case 1:
      camera.show(ctrl ? AxisView::kBack : AxisView::kFront);
      return true;
    case 3:
      camera.show(ctrl ? AxisView::kLeft : AxisView::kRight);
      return true;
    case 7:
      camera.show(ctrl ? AxisView::kBottom : AxisView::kTop);
      return true;
    case 5:
      camera.toggleProjection();
      return true;
    default:
      return false;
  }
}

}  // namespace stipple
