#pragma once

#include <imgui.h>

namespace stipple {

/// Drawn with lines of one weight, so that they are sharp at every scale.
enum class Icon {
  kPaint,
  kErase,
  kSmooth,
  kSelect,
  kPlay,
  kPause,
  kStep,
  kStop,
  kClose,
  kAdd,
  kChevron,
  kWarning,
  kNote
};

/// Centered on `center`, `size` pixels wide and high.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color);

}  // namespace stipple
