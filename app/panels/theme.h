#pragma once

struct ImFont;
struct ImFontAtlas;

namespace stipple {

enum class OverlayTheme { kDark, kLight };

/// `scale`: device pixels of what is one pixel on a plain screen.
struct OverlayLook {
  float scale = 1;
  OverlayTheme theme = OverlayTheme::kDark;
  friend bool operator==(const OverlayLook&, const OverlayLook&) = default;
};

/// Colors, paddings and roundings of the current context.
void applyStyle(const OverlayLook& look);

/// Replaces the fonts of an atlas and builds it.
void buildFonts(ImFontAtlas& atlas, float scale);

/// Fonts of the current context.
ImFont* bodyFont();
ImFont* smallFont();
ImFont* titleFont();

/// Scale of the current context.
float overlayScale();
/// Whole device pixels for a length on a plain screen.
float scaled(float length);

}  // namespace stipple
