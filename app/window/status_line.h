#pragma once

#include <QStatusBar>
#include <optional>

#include "app/view/frame_maker.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace stipple {

class Workbench;

/// Points, splats and time of the last frame, selection, and what is going on, with a button that cancels it.
class StatusLine final : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusLine(Workbench& workbench, QWidget* parent = nullptr);

  void showFrame(const std::optional<FrameNotes>& notes, const char* backend);

 private:
  void refreshPoints();
  void refreshTask();

  Workbench& workbench_;
  QLabel *points_, *frame_, *selection_, *task_;
  QProgressBar* progress_;
  QToolButton* cancel_;
};

}  // namespace stipple
