#pragma once

#include <functional>
#include <string>

#include "app/panels/overlay_context.h"
#include "render/appearance/image.h"

namespace stipple {

/// Draws panels as the plain viewport does, on a surface of sorts: a gray ground with soft shading.
class OverlayStage {
 public:
  OverlayStage(int width, int height, const OverlayLook& look = {});

  OverlayContext& context() { return context_; }
  /// One frame at 60 a second.
  void frame(const std::function<void()>& drawPanels);
  /// As many frames as panels need to find their sizes and to settle.
  void settle(const std::function<void()>& drawPanels);
  /// Moves to a place, presses and releases, with a frame after each.
  void click(glm::vec2 position, const std::function<void()>& drawPanels);
  /// Presses at one place, releases at another, in steps.
  void drag(glm::vec2 from, glm::vec2 to, const std::function<void()>& drawPanels);

  /// Clicks all over the view, from the left upper corner on, until `isDone` says so after a click; returns
  /// whether it did. Popups are closed in between.
  bool clickAround(const std::function<void()>& drawPanels, const std::function<bool()>& isDone);

  /// What the last frame drew, over the ground.
  Image picture();
  /// Writes the picture to tests/overlay/<name>.png of the build tree, for people to look at.
  void save(const std::string& name);

 private:
  OverlayContext context_;
  glm::ivec2 size_;
  const ImDrawData* drawing_ = nullptr;
};

}  // namespace stipple
