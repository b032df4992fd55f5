#include "app/window/commands.h"

#include <QMenu>
#include <QWidget>

#include "app/window/icons.h"

namespace stipple {

Commands::Commands(QWidget* window) : QObject(window), window_(window) {}

QAction* Commands::add(const Command& command, std::function<void()> run) {
  auto* action = new QAction(command.title, window_);
  action->setObjectName(QString::fromStdString(command.id));
  action->setShortcut(command.keys);
  action->setCheckable(command.isCheckable);
  if (command.icon) action->setIcon(iconOf(command.icon));
  const QString keys = command.keys.toString(QKeySequence::NativeText);
  QString tip = command.title;
  if (!keys.isEmpty()) tip += QString(" (%1)").arg(keys);
  if (!command.help.isEmpty()) tip += '\n' + command.help;
  action->setToolTip(tip);
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  window_->addAction(action);
  entries_.emplace(command.id, Entry{command, action});
  order_.push_back(command.id);
  return action;
}

QAction* Commands::action(const std::string& id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : found->second.action;
}

void Commands::fill(std::map<QString, QMenu*>& menus) const {
  for (const std::string& id : order_) {
    const Entry& entry = entries_.at(id);
    const auto menu = menus.find(entry.command.menu);
    if (menu == menus.end()) continue;
    if (entry.command.startsGroup) menu->second->addSeparator();
    menu->second->addAction(entry.action);
  }
}

void Commands::recolorIcons() {
  for (auto& [id, entry] : entries_) {
    if (entry.command.icon) entry.action->setIcon(iconOf(entry.command.icon));
  }
}

}  // namespace stipple
