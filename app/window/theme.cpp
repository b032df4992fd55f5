#include "app/window/theme.h"

#include <QApplication>
#include <QPalette>
#include <QString>
#include <QStyleFactory>

namespace stipple {

namespace {

// %1 window, %2 panel, %3 field, %4 field under the mouse, %5 border, %6 text, %7 faint text, %8 accent.
constexpr const char* kSheet = R"(
* { font-size: 10pt; }
QMainWindow, QDialog { background: %1; }
QMenuBar { background: %1; color: %6; padding: 1px 4px; border-bottom: 1px solid %5; }
QMenuBar::item { background: transparent; padding: 5px 9px; border-radius: 4px; }
QMenuBar::item:selected { background: %4; }
QMenu { background: %2; color: %6; border: 1px solid %5; padding: 5px; }
QMenu::item { padding: 5px 26px 5px 12px; border-radius: 4px; }
QMenu::item:selected { background: %8; color: #1a1a1a; }
QMenu::item:disabled { color: %7; background: transparent; }
QMenu::separator { height: 1px; background: %5; margin: 5px 4px; }
QMenu::icon { padding-left: 8px; }
QToolBar { background: %1; border: none; spacing: 2px; padding: 4px; }
QToolBar::separator { background: %5; margin: 5px 6px; height: 1px; width: 1px; }
QToolButton { background: transparent; border: none; border-radius: 5px; padding: 5px; color: %6; }
QToolButton:hover { background: %4; }
QToolButton:checked { background: %8; color: #1a1a1a; }
QToolButton:disabled { color: %7; }
QDockWidget { color: %7; font-weight: 600; titlebar-close-icon: none; titlebar-normal-icon: none; }
QDockWidget::title { background: %1; padding: 7px 10px 5px 10px; text-align: left; }
QScrollArea, QScrollArea > QWidget > QWidget { background: %2; border: none; }
QPushButton { background: %3; color: %6; border: 1px solid %5; border-radius: 5px; padding: 5px 12px; }
QPushButton:hover { background: %4; }
QPushButton:pressed { background: %5; }
QPushButton:disabled { color: %7; }
QPushButton[primary="true"] { background: %8; color: #1a1a1a; border: none; font-weight: 600; }
QPushButton[primary="true"]:hover { background: #ffb04a; }
QPushButton[primary="true"]:disabled { background: %3; color: %7; }
QLineEdit, QComboBox, QAbstractSpinBox, QPlainTextEdit, QTextBrowser {
  background: %3; color: %6; border: 1px solid %5; border-radius: 5px; padding: 4px 7px; selection-background-color: %8;
  selection-color: #1a1a1a; }
QLineEdit:focus, QComboBox:focus, QAbstractSpinBox:focus { border: 1px solid %8; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/icons/gray_down.svg); width: 13px; height: 13px; }
QComboBox QAbstractItemView { background: %2; color: %6; border: 1px solid %5; selection-background-color: %8;
  selection-color: #1a1a1a; outline: none; }
QCheckBox { color: %6; spacing: 7px; }
QCheckBox::indicator { width: 15px; height: 15px; border: 1px solid %5; border-radius: 4px; background: %3; }
QCheckBox::indicator:checked { background: %8; border: 1px solid %8; image: url(:/icons/dark_check.svg); }
QListWidget, QTreeWidget, QTableWidget { background: %2; color: %6; border: none; outline: none; }
QListWidget::item, QTreeWidget::item { padding: 3px 6px; border-radius: 4px; }
QListWidget::item:selected, QTreeWidget::item:selected { background: %4; color: %6; }
QHeaderView::section { background: %2; color: %7; border: none; padding: 4px; }
QLabel { color: %6; background: transparent; }
QLabel[faint="true"] { color: %7; }
QLabel[heading="true"] { color: %7; font-size: 9pt; font-weight: 600; }
QStatusBar { background: %1; color: %7; border-top: 1px solid %5; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: %7; padding: 1px 8px; }
QProgressBar { background: %3; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; }
QProgressBar::chunk { background: %8; border-radius: 3px; }
QTabBar::tab { background: %1; color: %7; padding: 6px 14px; border: none; }
QTabBar::tab:selected { background: %2; color: %6; border-bottom: 2px solid %8; }
QTabBar::close-button { subcontrol-position: right; image: url(:/icons/gray_close.svg); }
QTabBar::close-button:hover { background: %4; border-radius: 4px; }
QScrollBar:vertical { background: transparent; width: 9px; margin: 0; }
QScrollBar::handle:vertical { background: %5; border-radius: 4px; min-height: 24px; }
QScrollBar:horizontal { background: transparent; height: 9px; margin: 0; }
QScrollBar::handle:horizontal { background: %5; border-radius: 4px; min-width: 24px; }
QScrollBar::add-line, QScrollBar::sub-line, QScrollBar::add-page, QScrollBar::sub-page { background: none; border: none;
  width: 0; height: 0; }
QToolTip { background: %2; color: %6; border: 1px solid %5; padding: 4px; }
QMainWindow::separator { background: %5; width: 1px; height: 1px; }
)";

QPalette paletteOf(const ThemeColors& colors) {
  QPalette palette;
  palette.setColor(QPalette::Window, colors.window);
  palette.setColor(QPalette::WindowText, colors.text);
  palette.setColor(QPalette::Base, colors.field);
  palette.setColor(QPalette::AlternateBase, colors.panel);
  palette.setColor(QPalette::Text, colors.text);
  palette.setColor(QPalette::Button, colors.field);
  palette.setColor(QPalette::ButtonText, colors.text);
  palette.setColor(QPalette::ToolTipBase, colors.panel);
  palette.setColor(QPalette::ToolTipText, colors.text);
  palette.setColor(QPalette::PlaceholderText, colors.faintText);
  palette.setColor(QPalette::Highlight, colors.accent);
  palette.setColor(QPalette::HighlightedText, QColor(26, 26, 26));
  palette.setColor(QPalette::Link, colors.accent);
  palette.setColor(QPalette::Mid, colors.border);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, colors.faintText);
  return palette;
}

}  // namespace

const ThemeColors& colorsOf(Theme theme) {
  static const ThemeColors kDark{.window = "#2b2b2b",
                                 .panel = "#323232",
                                 .field = "#3c3c3c",
                                 .fieldHover = "#484848",
                                 .border = "#4d4d4d",
                                 .text = "#e4e4e4",
                                 .faintText = "#9d9d9d",
                                 .accent = "#ff981a",
                                 .viewport = "#2b2b2e"};
  static const ThemeColors kLight{.window = "#e6e6e6",
                                  .panel = "#f2f2f2",
                                  .field = "#ffffff",
                                  .fieldHover = "#d9d9d9",
                                  .border = "#c2c2c2",
                                  .text = "#1f1f1f",
                                  .faintText = "#6a6a6a",
                                  .accent = "#f08a0c",
                                  .viewport = "#c9c9cc"};
  return theme == Theme::kDark ? kDark : kLight;
}

void applyTheme(QApplication& application, Theme theme) {
  const ThemeColors& colors = colorsOf(theme);
  application.setStyle(QStyleFactory::create("Fusion"));
  application.setPalette(paletteOf(colors));
  QString sheet = QString(kSheet);
  int place = 1;
  for (const QColor& color : {colors.window, colors.panel, colors.field, colors.fieldHover, colors.border,
                              colors.text, colors.faintText, colors.accent}) {
    sheet.replace(QString("%%1").arg(place++), color.name());
  }
  application.setStyleSheet(sheet);
}

// Read before the application's own palette is set.
Theme systemTheme() {
  const QColor window = QPalette().color(QPalette::Window);
  const bool isPlainDefault = window == QColor(239, 239, 239) || window == QColor(240, 240, 240);
  return window.lightness() > 140 && !isPlainDefault ? Theme::kLight : Theme::kDark;
}

}  // namespace stipple
