#pragma once

#include <QMainWindow>
#include <memory>
#include <string>

#include "app/window/commands.h"
#include "app/window/settings.h"
#include "app/window/theme.h"
#include "app/window/view_controller.h"

class QDockWidget;
class QLineEdit;
class QTabBar;

namespace stipple {

class AttributePanel;
class ProcessPanel;
class StatusLine;
class Workbench;

/// Puts the parts together: menus, tool bar, docks, viewport, status line.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  struct Options {
    ViewportKind viewport = ViewportKind::kAuto;
    bool keepsQuiet = false;  ///< files were named: no cards, no offers
  };

  MainWindow(Workbench& workbench, Settings& settings, const Options& options);
  ~MainWindow() override;

  ViewController& view() { return *view_; }
  Commands& commands() { return *commands_; }
  AttributePanel& attributes() { return *attributePanel_; }
  ProcessPanel& processes() { return *processPanel_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void takeFirstSize();
  void buildCenter(ViewportKind kind);
  void buildDocks();
  void buildToolBar();
  void buildMenus();
  void buildSearch();
  void addFileCommands();
  void addEditCommands();
  void addViewCommands();
  void addSelectCommands();
  void addToolCommands();
  void addProcessCommands();
  void addHelpCommands();
  QDockWidget* addDock(const QString& title, QWidget* content, const char* name);
  void connectParts();

  void open();
  bool save();
  bool saveAs();
  bool mayClose(int index);
  void closeScan(int index);
  void saveRecipe();
  void playRecipe();
  void saveScreenshot();
  void storeNamedSelection();
  void recallNamedSelection();
  void focusSearch();
  void showShortcuts();
  void showAbout();
  void showPlugins();
  void setTheme(Theme theme);
  void foldPanels();
  void refreshTitle();
  void refreshTabs();
  void refreshActions();
  void refreshRecent();
  void paintInput(const PaintableInput& input);
  void followStroke(const std::string& attribute);
  void offerCards();
  void startCard(const QString& id);
  void recoverLatest();

  Workbench& workbench_;
  Settings& settings_;
  Options options_;
  Commands* commands_;
  ViewController* view_ = nullptr;
  QTabBar* tabs_ = nullptr;
  ProcessPanel* processPanel_ = nullptr;
  AttributePanel* attributePanel_ = nullptr;
  StatusLine* status_ = nullptr;
  QLineEdit* search_ = nullptr;
  QMenu* recent_ = nullptr;
  std::map<QString, QMenu*> menus_;
  std::vector<QDockWidget*> docks_, folded_;
};

}  // namespace stipple
