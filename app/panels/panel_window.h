#pragma once

#include <glm/vec2.hpp>

namespace stipple {

/// Where a panel may be, in device pixels. It is as high as its content, at most as high as the place, and
/// stands at the edges that `align` names: 0 left or top, 1 right or bottom, between them in between.
struct PanelPlace {
  glm::vec2 position{}, size{};
  glm::vec2 align{};
};

struct PanelOptions {
  bool fillsWidth = true;  ///< of its place; false: as wide as its content
  float opacity = 1;
};

/// A window of the overlay while it lives: no title, no moving, scrolled only where its place is too low.
class PanelWindow {
 public:
  PanelWindow(const char* name, const PanelPlace& place, const PanelOptions& options = {});
  ~PanelWindow();
  PanelWindow(const PanelWindow&) = delete;
  PanelWindow& operator=(const PanelWindow&) = delete;
};

}  // namespace stipple
