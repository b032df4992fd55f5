#include "app/window/status_line.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>

#include "app/window/icons.h"
#include "app/window/workbench.h"
#include "core/points/region.h"

namespace stipple {

namespace {

QString countText(std::size_t count) {
  return QLocale(QLocale::English).toString(static_cast<qulonglong>(count));
}

}  // namespace

StatusLine::StatusLine(Workbench& workbench, QWidget* parent)
    : QStatusBar(parent),
      workbench_(workbench),
      points_(new QLabel(this)),
      frame_(new QLabel(this)),
      selection_(new QLabel(this)),
      task_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
  setSizeGripEnabled(false);
  points_->setObjectName("points");
  selection_->setObjectName("selection");
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  progress_->setFixedWidth(120);
  cancel_->setIcon(iconOf("cancel"));
  cancel_->setIconSize({14, 14});
  cancel_->setToolTip(tr("Cancel"));
  for (QLabel* label : {points_, frame_, selection_}) addWidget(label);
  addPermanentWidget(task_);
  addPermanentWidget(progress_);
  addPermanentWidget(cancel_);
  connect(cancel_, &QToolButton::clicked, &workbench, [this] {
    if (workbench_.isRunning())
      workbench_.cancel();
    else
      workbench_.cancelTask();
  });
  connect(&workbench, &Workbench::pointsChanged, this, &StatusLine::refreshPoints);
  connect(&workbench, &Workbench::currentChanged, this, &StatusLine::refreshPoints);
  connect(&workbench, &Workbench::processChanged, this, &StatusLine::refreshTask);
  connect(&workbench, &Workbench::taskChanged, this, &StatusLine::refreshTask);
  refreshPoints();
  refreshTask();
}

void StatusLine::refreshPoints() {
  const OpenScan* scan = workbench_.current();
  points_->setText(scan ? tr("%1 points").arg(countText(scan->document.points().size()))
                        : tr("nothing open"));
  QString text;
  if (scan && scan->document.points().has("selection")) {
    const Index count =
        regionWhereNotZero(scan->document.points(), "selection").count(scan->document.points().size());
    text = tr("%1 selected").arg(countText(count));
  }
  selection_->setText(text);
}

void StatusLine::showFrame(const std::optional<FrameNotes>& notes, const char* backend) {
  if (!notes) return frame_->setText({});
  const QString what = notes->splats > 0 ? tr("%1 splats").arg(countText(notes->splats)) : tr("triangles");
  frame_->setText(tr("%1, %2 ms, %3").arg(what).arg(notes->milliseconds, 0, 'f', 0).arg(backend));
}

void StatusLine::refreshTask() {
  QString text;
  double fraction = 0;
  std::optional<double> left;
  if (const auto process = workbench_.process()) {
    text = QString::fromStdString(process->title);
    fraction = process->fraction;
    left = process->secondsLeft;
    if (process->isPaused) text += tr(", paused");
  } else if (const auto task = workbench_.task()) {
    text = QString::fromStdString(task->message);
    fraction = task->fraction;
    left = task->secondsLeft;
  }
  const bool isBusy = !text.isEmpty();
  if (isBusy) {
    text += QString(" %1 %").arg(100 * fraction, 0, 'f', 0);
    if (left) text += tr(", %1 s left").arg(std::max(1.0, *left), 0, 'f', 0);
  }
  task_->setText(text);
  progress_->setValue(static_cast<int>(1000 * fraction));
  progress_->setVisible(isBusy);
  cancel_->setVisible(isBusy);
}

}  // namespace stipple
