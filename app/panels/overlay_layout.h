#pragma once

#include <vector>

#include "app/panels/panel_window.h"

namespace stipple {

/// What is to be placed.
struct OverlayContent {
  bool brush = false, curve = false, statistics = false, legend = false, message = false;
  std::size_t cards = 0;
};

/// Places that lie within the view and do not overlap: brush and curve at the left, statistics and legend at
/// the right, cards and the message line below in the middle.
struct OverlayLayout {
  PanelPlace brush, curve, statistics, legend, message;
  std::vector<PanelPlace> cards;
};

/// `view` in device pixels. Down to about 700 x 560 unscaled pixels every panel has the room it asks for;
/// below, panels scroll, and of the cards as many are placed as fit.
OverlayLayout layOut(glm::vec2 view, float scale, const OverlayContent& content);

}  // namespace stipple
