#include <QAction>
#include <QMenu>

#include "tests/gui/window_test.h"

namespace stipple {
namespace {

using testing::SizeIs;

class SettingsOfTheWindow : public WindowTest {
 protected:
  QStringList recent() {
    QStringList paths;
    for (const QAction* action : find<QMenu>("recent")->actions()) paths << action->text();
    return paths;
  }
};

TEST_F(SettingsOfTheWindow, RecentFilesLastWithTheLatestFirst) {
  const auto first = writeSphere("first.ply", 300), second = writeSphere("second.ply", 400);
  open(first);
  open(second);
  open(first);
  const QStringList expected{QString::fromStdString(first.string()), QString::fromStdString(second.string())};
  EXPECT_EQ(recent(), expected);
  startWindow();
  EXPECT_EQ(recent(), expected);
  find<QMenu>("recent")->actions()[1]->trigger();
  waitFor("the scan", [this] { return workbench().current() != nullptr; });
  EXPECT_EQ(points().size(), 400u);
}

TEST_F(SettingsOfTheWindow, RefusedFilesAreNotRecent) {
  setContent(folder_ / "broken.ply", "ply\n");
  workbench().open(folder_ / "broken.ply");
  waitUntilIdle();
  EXPECT_TRUE(recent().isEmpty());
}

TEST_F(SettingsOfTheWindow, SizeAndThemeLast) {
  window().setWindowState(Qt::WindowNoState);
  window().resize(900, 600);
  waitFor("the size", [this] { return window().size() == QSize(900, 600); });
  choose("theme_light");
  ASSERT_TRUE(window().close());
  startWindow();
  waitFor("the size as it was", [this] { return window().size() == QSize(900, 600); });
  EXPECT_EQ(Settings().theme(), Theme::kLight);
}

}  // namespace
}  // namespace stipple
