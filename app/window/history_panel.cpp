#include "app/window/history_panel.h"

#include <QSignalBlocker>

#include "app/window/workbench.h"

namespace stipple {

HistoryPanel::HistoryPanel(Workbench& workbench, QWidget* parent)
    : QListWidget(parent), workbench_(workbench) {
  setObjectName("history");
  setUniformItemSizes(true);
  connect(&workbench, &Workbench::currentChanged, this, &HistoryPanel::refresh);
  connect(&workbench, &Workbench::pointsChanged, this, &HistoryPanel::refresh);
  connect(this, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { workbench_.goTo(static_cast<std::size_t>(row(item))); });
  refresh();
}

void HistoryPanel::refresh() {
  const QSignalBlocker quiet(this);
  const OpenScan* scan = workbench_.current();
  const std::size_t entries = scan ? scan->document.history().size() + 1 : 0;
  while (static_cast<std::size_t>(count()) > entries) delete takeItem(count() - 1);
  while (static_cast<std::size_t>(count()) < entries) addItem(QString());
  if (!scan) return;
  const History& history = scan->document.history();
  for (std::size_t at = 0; at < entries; ++at) {
    QListWidgetItem* held = item(static_cast<int>(at));
    held->setText(at == 0 ? tr("Open %1").arg(scan->title) : QString::fromStdString(history.title(at - 1)));
    held->setForeground(
        palette().color(at <= history.position() ? QPalette::Text : QPalette::PlaceholderText));
  }
  setCurrentRow(static_cast<int>(history.position()));
  scrollToItem(currentItem());
}

}  // namespace stipple
