#pragma once

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <functional>
#include <map>
#include <string>
#include <vector>

class QMenu;
class QWidget;

namespace stipple {

/// Something that the user can ask for by menu, key, tool bar or search.
struct Command {
  std::string id = {};  ///< stable; settings and tests name it
  QString menu = {};    ///< title of the menu that it stands in; empty: in none
  QString title = {};
  QKeySequence keys = {};
  const char* icon = nullptr;
  QString help = {};  ///< tool tip
  bool isCheckable = false;
  bool startsGroup = false;  ///< a line above it in the menu
};

/// All commands: one list from which menus, tool bars, the search and the list of shortcuts are made.
class Commands final : public QObject {
  Q_OBJECT

 public:
  explicit Commands(QWidget* window);

  QAction* add(const Command& command, std::function<void()> run);
  QAction* action(const std::string& id) const;
  const std::vector<std::string>& ids() const { return order_; }
  /// In the order of addition; `menus` by title, made where missing.
  void fill(std::map<QString, QMenu*>& menus) const;
  /// Icons in the colors of the present palette.
  void recolorIcons();

 private:
  struct Entry {
    Command command;
    QAction* action;
  };
  QWidget* window_;
  std::map<std::string, Entry> entries_;
  std::vector<std::string> order_;
};

}  // namespace stipple
