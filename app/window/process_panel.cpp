#include "app/window/process_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/window/icons.h"
#include "app/window/panel_wheel.h"
#include "app/window/parameter_form.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

QToolButton* makeButton(const char* icon, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(iconOf(icon));
  button->setIconSize({16, 16});
  button->setToolTip(tip);
  button->setObjectName(QString("process_%1").arg(icon));
  return button;
}

}  // namespace

ProcessPanel::ProcessPanel(Workbench& workbench, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      operators_(new QComboBox(this)),
      region_(new QComboBox(this)),
      help_(new QLabel(this)),
      regionTitle_(new QLabel(tr("Where"), this)),
      progressText_(new QLabel(this)),
      brushes_(new QWidget(this)),
      formPlace_(new QVBoxLayout) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 6, 10, 10);
  column->setSpacing(8);
  operators_->setObjectName("operators");
  leaveWheelToPanel(operators_);
  leaveWheelToPanel(region_);
  for (const auto& held : workbench.registry().operators()) {
    const OperatorDescription& d = held->description();
    operators_->addItem(QString::fromStdString(d.title), QString::fromStdString(d.id));
  }
  column->addWidget(operators_);
  help_->setWordWrap(true);
  help_->setProperty("faint", true);
  column->addWidget(help_);
  column->addWidget(brushes_);
  auto* where = new QHBoxLayout;
  where->addWidget(regionTitle_);
  where->addWidget(region_, 1);
  column->addLayout(where);
  buildRunRow(column);  // above the parameters, of which there may be more than the panel shows
  column->addLayout(formPlace_);
  column->addStretch(1);
  connect(operators_, &QComboBox::currentIndexChanged, this, [this] {
    rebuild();
    emit operatorChosen();
  });
  connect(&workbench, &Workbench::processChanged, this, &ProcessPanel::refreshRun);
  const auto followAttributes = [this] {
    if (attributeNames() != shownAttributes_) rebuild();
    refreshRun();
  };
  connect(&workbench, &Workbench::pointsChanged, this, followAttributes);
  connect(&workbench, &Workbench::currentChanged, this, followAttributes);
  if (const int first = operators_->findData("segmentation"); first >= 0) operators_->setCurrentIndex(first);
  rebuild();
  refreshRun();
}

void ProcessPanel::buildRunRow(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  run_ = new QPushButton(tr("Run"), this);
  run_->setProperty("primary", true);
  run_->setObjectName("run");
  run_->setToolTip(tr("Start the process on the surface (Ctrl+R). It can be undone in one step."));
  pause_ = makeButton("pause", tr("Pause, or go on"), this);
  step_ = makeButton("step", tr("One step"), this);
  stop_ = makeButton("stop", tr("Stop and keep what is there"), this);
  cancel_ = makeButton("cancel", tr("Cancel: the surface is as it was before (Esc)"), this);
  row->addWidget(run_, 1);
  for (QToolButton* button : {pause_, step_, stop_, cancel_}) row->addWidget(button);
  column->addLayout(row);
  progress_ = new QProgressBar(this);
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  column->addWidget(progress_);
  progressText_->setProperty("faint", true);
  column->addWidget(progressText_);
  connect(run_, &QPushButton::clicked, this, [this] { start(); });
  connect(pause_, &QToolButton::clicked, this, [this] {
    const auto state = workbench_.process();
    if (state && state->isPaused)
      workbench_.resume();
    else
      workbench_.pause();
  });
  connect(step_, &QToolButton::clicked, this, [this] {
    if (workbench_.isRunning())
      workbench_.stepOnce();
    else
      start(true);
  });
  connect(stop_, &QToolButton::clicked, &workbench_, &Workbench::stop);
  connect(cancel_, &QToolButton::clicked, &workbench_, &Workbench::cancel);
}

const OperatorDescription* ProcessPanel::description() const {
  const Operator* op = workbench_.registry().find(chosen());
  return op ? &op->description() : nullptr;
}

std::string ProcessPanel::chosen() const {
  return operators_->currentData().toString().toStdString();
}

std::vector<std::string> ProcessPanel::attributeNames() const {
  std::vector<std::string> names;
  if (const OpenScan* scan = workbench_.current()) {
    for (const Attribute& attribute : scan->document.points().attributes()) names.push_back(attribute.name);
  }
  return names;
}

void ProcessPanel::choose(const std::string& operatorId) {
  if (const int index = operators_->findData(QString::fromStdString(operatorId)); index >= 0)
    operators_->setCurrentIndex(index);
}

void ProcessPanel::rebuild() {
  const OperatorDescription* d = description();
  if (form_) {
    form_->hide();
    form_->deleteLater();
    form_ = nullptr;
  }
  if (!d) return;
  shownAttributes_ = attributeNames();
  help_->setText(QString::fromStdString(d->help));
  if (!kept_.contains(d->id)) kept_.emplace(d->id, Parameters(d->parameters));
  form_ = new ParameterForm(kept_.at(d->id), shownAttributes_, this);
  connect(form_, &ParameterForm::changed, this, &ProcessPanel::parametersChanged);
  formPlace_->addWidget(form_);
  rebuildBrushes(*d);
  refreshRegions(*d);
}

void ProcessPanel::rebuildBrushes(const OperatorDescription& d) {
  delete brushes_->layout();
  qDeleteAll(brushes_->findChildren<QPushButton*>(Qt::FindDirectChildrenOnly));
  auto* grid = new QGridLayout(brushes_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(5);
  const bool isOnly = d.paintable.size() == 1;
  int place = 0;
  for (const PaintableInput& input : d.paintable) {
    const QString title = QString::fromStdString(input.title.empty() ? input.attribute : input.title);
    auto* button =
        new QPushButton(iconOf("paint"), isOnly ? tr("Paint %1").arg(title.toLower()) : title, brushes_);
    button->setToolTip(tr("Paint %1 on the surface").arg(title.toLower()));
    button->setObjectName(QString("paint_%1").arg(QString::fromStdString(input.attribute)));
    connect(button, &QPushButton::clicked, this, [this, input] { emit paintRequested(input); });
    grid->addWidget(button, place / 2, place % 2, 1, isOnly ? 2 : 1);
    ++place;
  }
  brushes_->setVisible(!d.paintable.empty());
}

void ProcessPanel::refreshRegions(const OperatorDescription& d) {
  const QString before = region_->currentData().toString();
  const QSignalBlocker quiet(region_);
  region_->clear();
  if (d.region != RegionUse::kMask) region_->addItem(tr("the whole surface"), QString());
  for (const std::string& name : shownAttributes_) {
    const Attribute* attribute = workbench_.current()->document.points().find(name);
    if (attribute && attribute->type() != AttributeType::kVector3 &&
        attribute->type() != AttributeType::kColor)
      region_->addItem(tr("where %1 is not 0").arg(QString::fromStdString(name)),
                       QString::fromStdString(name));
  }
  const int wanted = region_->findData(QString::fromStdString(wantedRegion_));
  const bool isThere = !wantedRegion_.empty() && wanted >= 0;
  region_->setCurrentIndex(isThere ? wanted : std::max(0, region_->findData(before)));
  if (isThere) wantedRegion_.clear();
  const bool isUsed = d.region != RegionUse::kNone;
  region_->setVisible(isUsed);
  regionTitle_->setVisible(isUsed);
}

void ProcessPanel::parametersChanged() {
  const OperatorDescription* d = description();
  if (!d || !form_) return;
  kept_.insert_or_assign(d->id, form_->parameters());
  const auto state = workbench_.process();
  if (state && state->operatorId == d->id) workbench_.setProcessParameters(form_->parameters());
}

void ProcessPanel::setParameter(const std::string& id, const ParameterValue& value) {
  const OperatorDescription* d = description();
  if (!d) return;
  kept_.at(d->id).set(id, value);
  rebuild();
}

void ProcessPanel::setRegion(const std::string& attribute) {
  wantedRegion_ = attribute;
  if (const OperatorDescription* d = description()) refreshRegions(*d);
}

void ProcessPanel::start(bool paused) {
  const OperatorDescription* d = description();
  if (!d || !form_) return;
  Invocation invocation{.operatorId = d->id, .parameters = form_->parameters()};
  if (d->region != RegionUse::kNone) invocation.region = region_->currentData().toString().toStdString();
  workbench_.run(invocation, paused);
}

void ProcessPanel::refreshRun() {
  const auto state = workbench_.process();
  const bool isRunning = state.has_value();
  run_->setEnabled(workbench_.current() && !isRunning);
  operators_->setEnabled(!isRunning);
  for (QToolButton* button : {pause_, stop_, cancel_}) button->setEnabled(isRunning);
  step_->setEnabled(workbench_.current() && (!isRunning || state->isPaused));
  pause_->setIcon(iconOf(isRunning && state->isPaused ? "run" : "pause"));
  progress_->setValue(isRunning ? static_cast<int>(1000 * state->fraction) : 0);
  QString text;
  if (isRunning) {
    text = tr("step %1").arg(state->steps);
    if (!state->message.empty()) text += QString(", %1").arg(QString::fromStdString(state->message));
    if (state->isPaused) text += tr(", paused");
    if (state->secondsLeft) text += tr(", %1 s left").arg(std::max(1.0, *state->secondsLeft), 0, 'f', 0);
  }
  progressText_->setText(text);
}

}  // namespace stipple
