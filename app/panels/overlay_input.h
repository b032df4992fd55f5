#pragma once

namespace stipple {

enum class OverlayButton { kLeft, kRight, kMiddle };

/// The keys that fields of the overlay answer to; text comes as characters.
enum class OverlayKey {
  kTab,
  kLeft,
  kRight,
  kUp,
  kDown,
  kPageUp,
  kPageDown,
  kHome,
  kEnd,
  kInsert,
  kDelete,
  kBackspace,
  kSpace,
  kEnter,
  kEscape,
  kA,  ///< select all
  kC,
  kV,
  kX,
  kY,
  kZ,
};
constexpr int kOverlayKeys = static_cast<int>(OverlayKey::kZ) + 1;

struct OverlayModifiers {
  bool ctrl = false, shift = false, alt = false;
};

/// What the mouse should look like over a panel.
enum class OverlayCursor { kArrow, kText, kHand, kDragSideways };

}  // namespace stipple
