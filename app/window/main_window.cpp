#include "app/window/main_window.h"

#include <QCloseEvent>
#include <QCompleter>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QTabBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "app/window/attribute_panel.h"
#include "app/window/first_cards.h"
#include "app/window/history_panel.h"
#include "app/window/icons.h"
#include "app/window/process_panel.h"
#include "app/window/status_line.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

constexpr const char* kMenus[] = {"File", "Edit", "View", "Select", "Tools", "Process", "Help"};

}  // namespace

MainWindow::MainWindow(Workbench& workbench, Settings& settings, const Options& options)
    : workbench_(workbench), settings_(settings), options_(options), commands_(new Commands(this)) {
  setWindowTitle("Stipple");
  setAcceptDrops(true);
  setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks);
  buildCenter(options.viewport);
  buildDocks();
  status_ = new StatusLine(workbench, this);
  setStatusBar(status_);
  addFileCommands();
  addEditCommands();
  addViewCommands();
  addSelectCommands();
  addToolCommands();
  addProcessCommands();
  addHelpCommands();
  buildMenus();
  buildToolBar();
  buildSearch();
  connectParts();
  if (!restoreGeometry(settings.geometry())) takeFirstSize();
  restoreState(settings.layout());
  refreshTitle();
  refreshTabs();
  refreshActions();
  if (!options.keepsQuiet) offerCards();
}

// As large as it is comfortable to work in, and as the screen allows.
void MainWindow::takeFirstSize() {
  const QSize room = screen()->availableSize();
  resize(std::min(1600, room.width() * 9 / 10), std::min(1000, room.height() * 9 / 10));
  if (room.width() < 1500) setWindowState(Qt::WindowMaximized);
}

// The viewport goes before the widget that it lies in.
MainWindow::~MainWindow() {
  delete view_;
}

void MainWindow::buildCenter(ViewportKind kind) {
  auto* center = new QWidget(this);
  auto* column = new QVBoxLayout(center);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  tabs_ = new QTabBar(center);
  tabs_->setTabsClosable(true);
  tabs_->setExpanding(false);
  tabs_->setDocumentMode(true);
  tabs_->setVisible(false);
  column->addWidget(tabs_);
  std::string complaint;
  view_ = new ViewController(workbench_, makeViewport(kind, center, &complaint), this);
  view_->viewport().widget().setObjectName("viewport");
  column->addWidget(&view_->viewport().widget(), 1);
  setCentralWidget(center);
  if (!complaint.empty()) workbench_.say(QString::fromStdString(complaint));
}

QDockWidget* MainWindow::addDock(const QString& title, QWidget* content, const char* name) {
  auto* dock = new QDockWidget(title.toUpper(), this);
  dock->setObjectName(name);
  dock->setFeatures(QDockWidget::DockWidgetMovable);
  auto* scroll = new QScrollArea(dock);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  scroll->setMinimumWidth(330);
  dock->setWidget(scroll);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  docks_.push_back(dock);
  return dock;
}

void MainWindow::buildDocks() {
  processPanel_ = new ProcessPanel(workbench_);
  attributePanel_ = new AttributePanel(workbench_);
  addDock(tr("Process"), processPanel_, "dock_process");
  addDock(tr("Attributes"), attributePanel_, "dock_attributes");
  addDock(tr("History"), new HistoryPanel(workbench_), "dock_history");
  resizeDocks({docks_[0], docks_[1], docks_[2]}, {340, 260, 130}, Qt::Vertical);
}

void MainWindow::buildMenus() {
  for (const char* name : kMenus) menus_[tr(name)] = nullptr;
  for (const char* name : kMenus) menus_[tr(name)] = menuBar()->addMenu(tr(name));
  commands_->fill(menus_);
  recent_ = new QMenu(tr("Open recent"), this);
  recent_->setObjectName("recent");
  menus_[tr("File")]->insertMenu(commands_->action("save"), recent_);
  refreshRecent();
}

void MainWindow::buildToolBar() {
  auto* bar = new QToolBar(tr("Tools"), this);
  bar->setObjectName("toolbar");
  bar->setMovable(false);
  bar->setOrientation(Qt::Vertical);
  bar->setIconSize({20, 20});
  for (const char* id : {"tool_orbit", "tool_paint", "tool_erase", "tool_smooth"})
    bar->addAction(commands_->action(id));
  bar->addSeparator();
  for (const char* id : {"tool_select", "tool_rectangle", "tool_lasso"})
    bar->addAction(commands_->action(id));
  bar->addSeparator();
  for (const char* id : {"tool_measure", "tool_inspect"}) bar->addAction(commands_->action(id));
  bar->addSeparator();
  for (const char* id : {"undo", "redo", "frame"}) bar->addAction(commands_->action(id));
  addToolBar(Qt::LeftToolBarArea, bar);
}

// Any command by its title.
void MainWindow::buildSearch() {
  search_ = new QLineEdit(this);
  search_->setObjectName("search");
  search_->setPlaceholderText(tr("Search for any command (Ctrl+Space)"));
  search_->setFixedWidth(270);
  QStringList titles;
  for (const std::string& id : commands_->ids()) titles << commands_->action(id)->text();
  auto* completer = new QCompleter(titles, search_);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  completer->setFilterMode(Qt::MatchContains);
  search_->setCompleter(completer);
  // The menu bar goes by the size hint of its corner.
  auto* corner = new QWidget(this);
  auto* row = new QHBoxLayout(corner);
  row->setContentsMargins(0, 2, 6, 2);
  row->addWidget(search_);
  menuBar()->setCornerWidget(corner, Qt::TopRightCorner);
  const auto trigger = [this](const QString& title) {
    for (const std::string& id : commands_->ids()) {
      QAction* action = commands_->action(id);
      if (action->text().compare(title, Qt::CaseInsensitive) != 0 || !action->isEnabled()) continue;
      action->trigger();
      break;
    }
    QMetaObject::invokeMethod(search_, &QLineEdit::clear, Qt::QueuedConnection);
    view_->viewport().widget().setFocus();
  };
  connect(completer, qOverload<const QString&>(&QCompleter::activated), this, trigger);
  connect(search_, &QLineEdit::returnPressed, this, [this, trigger, completer] {
    if (completer->popup() == nullptr || completer->currentCompletion().isEmpty()) return;
    trigger(completer->currentCompletion());
  });
}

void MainWindow::connectParts() {
  connect(tabs_, &QTabBar::currentChanged, &workbench_, &Workbench::setCurrent);
  connect(tabs_, &QTabBar::tabCloseRequested, this, &MainWindow::closeScan);
  connect(&workbench_, &Workbench::scansChanged, this, &MainWindow::refreshTabs);
  for (const auto signal : {&Workbench::currentChanged, &Workbench::pointsChanged, &Workbench::saved}) {
    connect(&workbench_, signal, this, &MainWindow::refreshTitle);
    connect(&workbench_, signal, this, &MainWindow::refreshActions);
  }
  connect(&workbench_, &Workbench::processChanged, this, &MainWindow::refreshActions);
  connect(&workbench_, &Workbench::scansChanged, this, &MainWindow::refreshRecent);
  connect(view_, &ViewController::pictureChanged, this,
          [this] { status_->showFrame(view_->viewport().notes(), view_->viewport().backend()); });
  connect(view_, &ViewController::toolChanged, this, &MainWindow::refreshActions);
  connect(attributePanel_, &AttributePanel::lookChanged, view_, &ViewController::relook);
  connect(attributePanel_, &AttributePanel::valuesMarked, view_, &ViewController::selectByValue);
  connect(view_, &ViewController::strokeEnded, this, &MainWindow::followStroke);
  connect(view_, &ViewController::cardStarted, this, &MainWindow::startCard);
  connect(&workbench_, &Workbench::opened, this, [this](const QString& path) {
    settings_.addRecentFile(path);
    refreshRecent();
  });
  connect(processPanel_, &ProcessPanel::paintRequested, this, &MainWindow::paintInput);
}

// The brush for what an operator declares as paintable; its parameter names the attribute from then on.
void MainWindow::paintInput(const PaintableInput& input) {
  view_->paintAttribute(input.attribute, {1}, input.kind);
  if (input.parameter.empty())
    processPanel_->setRegion(input.attribute);
  else
    processPanel_->setParameter(input.parameter, input.attribute);
  view_->viewport().widget().setFocus();  // the keys of the brush
}

// Some operators are worth running after every stroke on what they are told by painting.
void MainWindow::followStroke(const std::string& attribute) {
  const Operator* op = workbench_.registry().find(processPanel_->chosen());
  if (!op || !op->description().runsAtEndOfStroke || workbench_.isRunning()) return;
  const auto& inputs = op->description().paintable;
  if (std::ranges::find(inputs, attribute, &PaintableInput::attribute) != inputs.end())
    processPanel_->start();
}

// At an empty start: lost work first, then what there is to try.
void MainWindow::offerCards() {
  std::vector<HintCard> cards = firstCards(workbench_.registry());
  if (const std::vector<LostWork> lost = workbench_.lostWork(); !lost.empty())
    cards = {recoveryCard(lost.front().base.file.filename().string(), lost.front().entries)};
  view_->overlay().cards = std::move(cards);
  view_->viewport().widget().update();
}

void MainWindow::recoverLatest() {
  const std::vector<LostWork> lost = workbench_.lostWork();
  if (lost.empty()) return workbench_.say(tr("There is no unsaved work from a breakdown."));
  workbench_.recover(lost.front());
}

void MainWindow::startCard(const QString& id) {
  view_->overlay().cards.clear();
  if (id == kRecoveryCard) return recoverLatest();
  if (id == "segment") {
    processPanel_->choose("segmentation");
    view_->paintAttribute("seeds", {1});
    processPanel_->setParameter("seeds", std::string("seeds"));
    workbench_.say(tr("Paint on one part, choose another label, paint on another part, then press Run."));
  } else if (id == "zebra") {
    processPanel_->choose("texture_synthesis");
    processPanel_->setParameter("pattern", std::string("zebra"));
    processPanel_->setParameter("color", true);
    processPanel_->start();
  } else if (id == "creases") {
    processPanel_->choose("classifier");
    processPanel_->start();
  } else if (id == "repair") {
    processPanel_->choose("inpainting");
    paintInput({.kind = PaintKind::kMask, .attribute = "mask"});
    workbench_.say(tr("Paint over a blemish: it is repaired when the stroke ends."));
  } else {
    view_->paintAttribute("color", {222, 56, 32});
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  for (int index = static_cast<int>(workbench_.scans().size()) - 1; index >= 0; --index) {
    if (!mayClose(index)) return event->ignore();
  }
  settings_.setWindow(saveGeometry(), saveState());
  workbench_.closeAll();
  event->accept();
}

// What no panel took: Esc takes back wherever the focus is.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && view_->escape()) return;
  QMainWindow::keyPressEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) workbench_.open(url.toLocalFile().toStdString());
  }
  event->acceptProposedAction();
}

void MainWindow::foldPanels() {
  if (!folded_.empty()) {
    for (QDockWidget* dock : folded_) dock->show();
    folded_.clear();
    return;
  }
  for (QDockWidget* dock : docks_) {
    if (!dock->isVisible()) continue;
    dock->hide();
    folded_.push_back(dock);
  }
}

void MainWindow::refreshTitle() {
  const OpenScan* scan = workbench_.current();
  setWindowTitle(scan ? QString("%1[*] - Stipple").arg(scan->title) : QString("Stipple"));
  setWindowModified(scan && scan->document.isModified());
  for (int index = 0; index < tabs_->count(); ++index) {
    const OpenScan& held = *workbench_.scans()[static_cast<std::size_t>(index)];
    tabs_->setTabText(index, held.title + (held.document.isModified() ? " *" : ""));
  }
}

void MainWindow::refreshTabs() {
  const QSignalBlocker quiet(tabs_);
  const auto count = static_cast<int>(workbench_.scans().size());
  while (tabs_->count() > count) tabs_->removeTab(tabs_->count() - 1);
  while (tabs_->count() < count) tabs_->addTab(QString());
  tabs_->setCurrentIndex(workbench_.currentIndex());
  tabs_->setVisible(count > 1);
  refreshTitle();
}

}  // namespace stipple
