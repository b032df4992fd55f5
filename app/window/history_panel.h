#pragma once

#include <QListWidget>

namespace stipple {

class Workbench;

/// What was done, oldest first, with what was undone in gray below: a click goes there.
class HistoryPanel final : public QListWidget {
  Q_OBJECT

 public:
  explicit HistoryPanel(Workbench& workbench, QWidget* parent = nullptr);

 private:
  void refresh();

  Workbench& workbench_;
};

}  // namespace stipple
