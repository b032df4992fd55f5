#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTableWidget>
#include <QTest>
#include <map>
#include <set>

#include "tests/gui/window_test.h"

namespace stipple {
namespace {

using Command = WindowTest;

TEST_F(Command, EachHasATitleAndKeysOfItsOwn) {
  const std::vector<std::string>& ids = window().commands().ids();
  ASSERT_GT(ids.size(), 40u);
  std::map<QString, std::string> keys;
  std::map<QString, std::string> titles;
  for (const std::string& id : ids) {
    const QAction* action = window().commands().action(id);
    EXPECT_FALSE(action->text().isEmpty()) << id;
    EXPECT_TRUE(action->toolTip().startsWith(action->text())) << id;
    if (!id.starts_with("operator_")) {
      const auto [other, isNew] = titles.emplace(action->text(), id);
      EXPECT_TRUE(isNew) << id << " and " << other->second << " have the same title";
    }
    if (action->shortcut().isEmpty()) continue;
    const auto [other, isNew] = keys.emplace(action->shortcut().toString(), id);
    EXPECT_TRUE(isNew) << id << " and " << other->second << " have the same key";
  }
}

TEST_F(Command, EachStandsInAMenu) {
  std::vector<const QAction*> shown;
  for (const QAction* top : window().menuBar()->actions()) {
    ASSERT_NE(top->menu(), nullptr);
    EXPECT_FALSE(top->menu()->isEmpty()) << top->text().toStdString();
    for (const QAction* action : top->menu()->actions()) shown.push_back(action);
  }
  for (const std::string& id : window().commands().ids()) {
    if (id == "search") continue;  // its field stands beside the menus
    EXPECT_EQ(std::ranges::count(shown, window().commands().action(id)), 1) << id;
  }
}

TEST_F(Command, ShortcutsAreListedWithTheirKeys) {
  std::set<std::pair<QString, QString>> listed;
  whenDialogOpens([&](QWidget& dialog) {
    const auto* table = dialog.findChild<QTableWidget*>();
    ASSERT_NE(table, nullptr);
    for (int row = 0; row < table->rowCount(); ++row)
      listed.emplace(table->item(row, 0)->text(), table->item(row, 1)->text());
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  key(Qt::Key_F1);
  for (const std::string& id : window().commands().ids()) {
    const QAction* action = window().commands().action(id);
    if (action->shortcut().isEmpty()) continue;
    EXPECT_TRUE(listed.contains({action->text(), action->shortcut().toString(QKeySequence::NativeText)}))
        << id;
  }
}

TEST_F(Command, SearchFindsAndDoesOne) {
  openSphere(1000);
  key(Qt::Key_Space, Qt::ControlModifier);
  QWidget* search = QApplication::focusWidget();
  ASSERT_EQ(search, find<QLineEdit>("search"));
  QTest::keyClicks(search, "top vi");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_NEAR(glm::normalize(scan().camera.eye()).z, 1, 1e-3);
}

TEST_F(Command, ThemesChangeTheLook) {
  openSphere(1000);
  const auto brightness = [this](QWidget& widget, const QPoint& at) {
    return widget.grab().toImage().pixelColor(at).lightness();
  };
  QWidget& picture = view().viewport().widget();
  choose("theme_dark");
  waitFor("a dark background", [&] { return brightness(picture, {3, picture.height() / 2}) < 100; });
  EXPECT_LT(brightness(window(), {3, 3}), 100);
  EXPECT_LT(qApp->palette().color(QPalette::Window).lightness(), 100);
  choose("theme_light");
  waitFor("a light background", [&] { return brightness(picture, {3, picture.height() / 2}) > 150; });
  EXPECT_GT(brightness(window(), {3, 3}), 150);
  EXPECT_EQ(Settings().theme(), Theme::kLight);
  choose("theme_dark");
}

TEST_F(Command, WithoutAScanNothingIsHarmed) {
  for (const std::string& id : window().commands().ids()) {
    QAction* action = window().commands().action(id);
    const bool opensADialog =
        action->text().endsWith("...") || id == "shortcuts" || id == "plugins" || id == "about";
    if (!action->isEnabled() || opensADialog || id == "quit" || id == "sample") continue;
    action->trigger();
  }
  QApplication::processEvents();
  EXPECT_TRUE(workbench().scans().empty());
}

}  // namespace
}  // namespace stipple
