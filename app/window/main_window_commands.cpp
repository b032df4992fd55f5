// The commands of the main window: what stands in menus, tool bar, search and the list of shortcuts.
#include <QActionGroup>
#include <QApplication>
#include <QMenu>

#include "app/tools/graph_selection.h"
#include "app/tools/selection.h"
#include "app/window/main_window.h"
#include "app/window/process_panel.h"
#include "app/window/workbench.h"

namespace stipple {

void MainWindow::addFileCommands() {
  const QString menu = tr("File");
  commands_->add(
      {.id = "open", .menu = menu, .title = tr("Open..."), .keys = QKeySequence::Open, .icon = "open"},
      [this] { open(); });
  commands_->add(
      {.id = "save", .menu = menu, .title = tr("Save"), .keys = QKeySequence::Save, .icon = "save"},
      [this] { save(); });
  commands_->add(
      {.id = "save_as", .menu = menu, .title = tr("Save as..."), .keys = QKeySequence("Ctrl+Shift+S")},
      [this] { saveAs(); });
  commands_->add({.id = "save_recipe",
                  .menu = menu,
                  .title = tr("Save recipe..."),
                  .help = tr("What was done, as a file that stipple-cli play and other scans understand"),
                  .startsGroup = true},
                 [this] { saveRecipe(); });
  commands_->add({.id = "play_recipe", .menu = menu, .title = tr("Play recipe...")},
                 [this] { playRecipe(); });
  commands_->add({.id = "screenshot",
                  .menu = menu,
                  .title = tr("Save picture..."),
                  .keys = QKeySequence("Ctrl+Shift+P"),
                  .icon = "camera",
                  .startsGroup = true},
                 [this] { saveScreenshot(); });
  commands_->add(
      {.id = "close", .menu = menu, .title = tr("Close"), .keys = QKeySequence::Close, .startsGroup = true},
      [this] {
        if (workbench_.current()) closeScan(workbench_.currentIndex());
      });
  commands_->add({.id = "quit", .menu = menu, .title = tr("Quit"), .keys = QKeySequence("Ctrl+Q")},
                 [this] { QMainWindow::close(); });
}

void MainWindow::addEditCommands() {
  const QString menu = tr("Edit");
  commands_->add(
      {.id = "undo", .menu = menu, .title = tr("Undo"), .keys = QKeySequence("Ctrl+Z"), .icon = "undo"},
      [this] { workbench_.undo(); });
  commands_->add(
      {.id = "redo", .menu = menu, .title = tr("Redo"), .keys = QKeySequence("Ctrl+Shift+Z"), .icon = "redo"},
      [this] { workbench_.redo(); });
  commands_->add({.id = "flip_normals",
                  .menu = menu,
                  .title = tr("Flip normals"),
                  .help = tr("Turns the normals of the selection, or of all points, to the other side"),
                  .startsGroup = true},
                 [this] { workbench_.flipNormals(); });
  commands_->add({.id = "delete_selection",
                  .menu = menu,
                  .title = tr("Delete selected points"),
                  .keys = QKeySequence::Delete},
                 [this] { workbench_.deleteSelection(); });
}

void MainWindow::addViewCommands() {
  const QString menu = tr("View");
  const auto add = [&](Command command, std::function<void()> run) {
    command.menu = menu;
    return commands_->add(command, std::move(run));
  };
  add({.id = "frame", .title = tr("Frame the model"), .keys = QKeySequence("Home"), .icon = "frame"},
      [this] { view_->frameModel(); });
  const std::pair<const char*, int> kSides[] = {{"Front", 1}, {"Right", 3}, {"Top", 7}};
  for (const auto& [name, digit] : kSides) {
    add({.id = QString("view_%1").arg(name).toLower().toStdString(),
         .title = tr("%1 view").arg(tr(name)),
         .keys = QKeySequence(QString::number(digit))},
        [this, digit] { view_->applyViewKey(digit, false); });
    add({.id = QString("view_opposite_%1").arg(name).toLower().toStdString(),
         .title = tr("Opposite of %1 view").arg(tr(name).toLower()),
         .keys = QKeySequence(QString("Ctrl+%1").arg(digit))},
        [this, digit] { view_->applyViewKey(digit, true); });
  }
  add({.id = "projection", .title = tr("Perspective or orthographic"), .keys = QKeySequence("5")},
      [this] { view_->toggleProjection(); });
  auto* up = new QActionGroup(this);
  up->addAction(add({.id = "up_z", .title = tr("Z is up"), .isCheckable = true, .startsGroup = true},
                    [this] { view_->setUpAxis(UpAxis::kZ); }));
  up->addAction(add({.id = "up_y", .title = tr("Y is up"), .isCheckable = true},
                    [this] { view_->setUpAxis(UpAxis::kY); }));
  auto* modes = new QActionGroup(this);
  const std::tuple<const char*, const char*, SplatMode> kModes[] = {
      {"mode_splats", "Blended splats", SplatMode::kSplats},
      {"mode_discs", "Discs", SplatMode::kDiscs},
      {"mode_points", "Points", SplatMode::kPoints}};
  for (const auto& [id, title, mode] : kModes) {
    QAction* action =
        add({.id = id, .title = tr(title), .isCheckable = true, .startsGroup = mode == SplatMode::kSplats},
            [this, m = mode] { view_->setMode(m); });
    action->setChecked(mode == SplatMode::kSplats);
    modes->addAction(action);
  }
  add({.id = "mesh", .title = tr("Triangles"), .isCheckable = true}, [this] {
    if (OpenScan* scan = workbench_.current()) {
      scan->look.asMesh = commands_->action("mesh")->isChecked();
      view_->relook();
    }
  });
  add({.id = "panels", .title = tr("Fold panels away"), .keys = QKeySequence("Tab"), .startsGroup = true},
      [this] { foldPanels(); });
  add({.id = "statistics", .title = tr("Frame statistics"), .isCheckable = true},
      [this] { view_->showStatistics(commands_->action("statistics")->isChecked()); });
  add({.id = "theme_dark", .title = tr("Dark theme")}, [this] { setTheme(Theme::kDark); });
  add({.id = "theme_light", .title = tr("Light theme")}, [this] { setTheme(Theme::kLight); });
}

void MainWindow::addSelectCommands() {
  const auto add = [&](Command command, SelectionChange change) {
    command.menu = tr("Select");
    commands_->add(command, [this, change] { view_->changeSelection(change); });
  };
  add({.id = "select_all", .title = tr("Select all"), .keys = QKeySequence("Ctrl+A")}, SelectionChange::kAll);
  add({.id = "select_none", .title = tr("Select nothing"), .keys = QKeySequence("Ctrl+Shift+A")},
      SelectionChange::kNone);
  add({.id = "select_invert", .title = tr("Invert selection"), .keys = QKeySequence("Ctrl+I")},
      SelectionChange::kInvert);
  add({.id = "select_grow",
       .title = tr("Grow selection"),
       .keys = QKeySequence("Ctrl++"),
       .startsGroup = true},
      SelectionChange::kGrow);
  add({.id = "select_shrink", .title = tr("Shrink selection"), .keys = QKeySequence("Ctrl+-")},
      SelectionChange::kShrink);
  commands_->add(
      {.id = "select_store", .menu = tr("Select"), .title = tr("Name the selection..."), .startsGroup = true},
      [this] { storeNamedSelection(); });
  commands_->add({.id = "select_recall", .menu = tr("Select"), .title = tr("Select by name...")},
                 [this] { recallNamedSelection(); });
}

void MainWindow::addToolCommands() {
  struct Entry {
    Tool tool;
    const char *id, *title, *key, *icon, *help;
  };
  static constexpr Entry kTools[] = {
      {Tool::kOrbit, "tool_orbit", "Orbit", "Q", "orbit",
       "Left drag turns, middle drag pans, the wheel zooms"},
      {Tool::kPaint, "tool_paint", "Paint", "B", "paint",
       "Paints on the surface; beside it, drags turn the view"},
      {Tool::kErase, "tool_erase", "Erase", "E", "erase", "Takes away what was painted"},
      {Tool::kSmooth, "tool_smooth", "Smooth", "S", "smooth", "Evens out what was painted"},
      {Tool::kSelect, "tool_select", "Selection brush", "C", "select",
       "Selects what it touches (Ctrl removes)"},
      {Tool::kRectangle, "tool_rectangle", "Select a rectangle", "R", "rectangle",
       "Shift adds, Ctrl removes"},
      {Tool::kLasso, "tool_lasso", "Lasso", "L", "lasso", "Shift adds, Ctrl removes"},
      {Tool::kMeasure, "tool_measure", "Measure a distance", "M", "measure",
       "Click two places on the surface"},
      {Tool::kInspect, "tool_inspect", "Inspect a point", "I", "inspect",
       "A click shows a point's neighborhood, fan, frame and matrix row"}};
  auto* group = new QActionGroup(this);
  for (const Entry& entry : kTools) {
    QAction* action = commands_->add({.id = entry.id,
                                      .menu = tr("Tools"),
                                      .title = tr(entry.title),
                                      .keys = QKeySequence(entry.key),
                                      .icon = entry.icon,
                                      .help = tr(entry.help),
                                      .isCheckable = true},
                                     [this, tool = entry.tool] { view_->setTool(tool); });
    action->setChecked(entry.tool == Tool::kOrbit);
    action->setData(static_cast<int>(entry.tool));
    group->addAction(action);
  }
}

void MainWindow::addProcessCommands() {
  const QString menu = tr("Process");
  commands_->add(
      {.id = "run", .menu = menu, .title = tr("Run"), .keys = QKeySequence("Ctrl+R"), .icon = "run"},
      [this] { processPanel_->start(); });
  commands_->add({.id = "pause",
                  .menu = menu,
                  .title = tr("Pause or go on"),
                  .keys = QKeySequence("P"),
                  .icon = "pause"},
                 [this] { workbench_.togglePause(); });
  commands_->add({.id = "stop", .menu = menu, .title = tr("Stop and keep"), .icon = "stop"},
                 [this] { workbench_.stop(); });
  commands_->add({.id = "cancel", .menu = menu, .title = tr("Cancel"), .icon = "cancel"},
                 [this] { workbench_.cancel(); });
  bool isFirst = true;
  for (const auto& held : workbench_.registry().operators()) {
    const OperatorDescription& d = held->description();
    commands_->add({.id = "operator_" + d.id,
                    .menu = menu,
                    .title = QString::fromStdString(d.title),
                    .help = QString::fromStdString(d.help),
                    .startsGroup = std::exchange(isFirst, false)},
                   [this, id = d.id] { processPanel_->choose(id); });
  }
}

void MainWindow::addHelpCommands() {
  const QString menu = tr("Help");
  commands_->add({.id = "shortcuts", .menu = menu, .title = tr("All shortcuts"), .keys = QKeySequence("F1")},
                 [this] { showShortcuts(); });
  commands_->add({.id = "plugins", .menu = menu, .title = tr("Plugins")}, [this] { showPlugins(); });
  commands_->add({.id = "about", .menu = menu, .title = tr("About Stipple")}, [this] { showAbout(); });
  commands_->add({.id = "search", .title = tr("Search for a command"), .keys = QKeySequence("Ctrl+Space")},
                 [this] { focusSearch(); });
  commands_->add({.id = "sample", .menu = menu, .title = tr("Open the sample"), .startsGroup = true},
                 [this] { workbench_.openSample(); });
}

void MainWindow::refreshActions() {
  const OpenScan* scan = workbench_.current();
  const bool isRunning = workbench_.isRunning();
  const auto enable = [this](const char* id, bool isOn) { commands_->action(id)->setEnabled(isOn); };
  enable("undo", scan && scan->document.history().canUndo());
  enable("redo", scan && scan->document.history().canRedo());
  for (const char* id : {"save", "save_as", "close", "save_recipe", "play_recipe", "screenshot", "frame",
                         "flip_normals", "select_all", "select_none", "select_invert"})
    enable(id, scan != nullptr);
  enable("run", scan && !isRunning);
  for (const char* id : {"pause", "stop", "cancel"}) enable(id, isRunning);
  const bool isSelected = scan && scan->document.points().has("selection");
  for (const char* id : {"select_grow", "select_shrink", "select_store", "delete_selection"})
    enable(id, isSelected);
  enable("mesh", scan && !scan->document.points().triangles().empty());
  if (scan) {
    commands_->action("mesh")->setChecked(scan->look.asMesh);
    commands_->action(scan->camera.up() == UpAxis::kZ ? "up_z" : "up_y")->setChecked(true);
  }
  for (const std::string& id : commands_->ids()) {
    QAction* action = commands_->action(id);
    if (id.starts_with("tool_") && action->data().toInt() == static_cast<int>(view_->tool()))
      action->setChecked(true);
  }
}

}  // namespace stipple
