#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QMouseEvent>
#include <QPoint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/window/main_window.h"
#include "app/window/workbench.h"
#include "tests/support/temporary_folder.h"

class QDialog;
class QListWidget;

namespace stipple {

/// The real window on a screen of its own. Mouse and keys reach it as the window system brings them;
/// positions are pixels of the view. The operators are those of the plugins in the build folder and those for
/// tests.
class WindowTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// A new window, as another start of the program: closes the one before without asking.
  void startWindow(ViewportKind kind = ViewportKind::kCpu);
  void endWindow();

  Workbench& workbench() { return *workbench_; }
  MainWindow& window() { return *window_; }
  ViewController& view() { return window_->view(); }
  OpenScan& scan() { return *workbench_->current(); }
  const PointSet& points() { return scan().document.points(); }
  template <class Widget>
  Widget* find(const char* name) {
    return window_->findChild<Widget*>(name);
  }

  /// Lets events pass until it holds; a failure where it never does.
  static bool waitFor(const char* what, const std::function<bool()>& holds, int milliseconds = 120'000);
  /// Until nothing is read, written, prepared or run.
  void waitUntilIdle();
  /// Until the picture shows the present state from the present camera as well as it can.
  void waitForPicture();

  /// `count` points, evenly on the unit sphere, with their normals and `altitude` = z, in a new PLY file.
  std::filesystem::path writeSphere(const std::string& name, Index count = 6000);
  /// Opens it as Ctrl+O would, and waits for its picture.
  OpenScan& open(const std::filesystem::path& path);
  OpenScan& openSphere(Index count = 6000) { return open(writeSphere("sphere.ply", count)); }

  QPoint center();
  void press(const QPoint& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers held = {});
  void moveTo(const QPoint& at, Qt::KeyboardModifiers held = {});
  void release(const QPoint& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers held = {});
  /// Presses at the first place, moves to the others in small steps and releases at the last.
  void drag(const std::vector<QPoint>& places, Qt::KeyboardModifiers held = {},
            Qt::MouseButton button = Qt::LeftButton);
  void turnWheel(const QPoint& at, int steps, Qt::KeyboardModifiers held = {});
  /// To whatever has the focus, by way of the shortcuts.
  void key(Qt::Key key, Qt::KeyboardModifiers held = {});
  void typeInto(QWidget& field, const QString& text);
  static void click(QWidget& widget);
  /// Chooses a command in its menu, as a click there would.
  void choose(const std::string& command);
  /// Chooses an operator in the panel and types values into the fields of its whole-number parameters.
  void chooseOperator(const std::string& id, const std::vector<std::pair<const char*, int>>& numbers = {});
  void clickHistory(int row);
  QListWidget& history();

  /// The next dialog that opens is driven by `drive`, from within its own event loop.
  void whenDialogOpens(std::function<void(QWidget& dialog)> drive);
  /// Answers the next file dialog.
  void answerFileDialog(const std::filesystem::path& path);
  bool dialogWasDriven() const { return driven_ > 0 && awaited_ == 0; }

  /// The pixel that shows a point of the current scan.
  glm::vec2 pixelOf(Index row);

  TemporaryFolder folder_;
  std::vector<QString> said_;  ///< sentences for the user since they were last cleared

 private:
  void activate();
  void pollForDialog(std::function<void(QWidget&)> drive);

  std::unique_ptr<Settings> settings_;
  std::unique_ptr<Workbench> workbench_;
  std::unique_ptr<MainWindow> window_;
  QPoint lastMove_;
  int awaited_ = 0, driven_ = 0;
};

}  // namespace stipple
