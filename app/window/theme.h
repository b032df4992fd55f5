#pragma once

#include <QColor>

class QApplication;

namespace stipple {

enum class Theme { kDark, kLight };

/// Colors of the window. Grays are neutral, so that they do not tint what is shown.
struct ThemeColors {
  QColor window, panel, field, fieldHover, border, text, faintText, accent, viewport;
};
const ThemeColors& colorsOf(Theme theme);

/// Palette, style sheet and style of the whole application.
void applyTheme(QApplication& application, Theme theme);

/// What the desktop asks for; dark where it does not tell.
Theme systemTheme();

}  // namespace stipple
