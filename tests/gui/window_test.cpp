#include "tests/gui/window_test.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <QWindow>
#include <cmath>
#include <numbers>

#include "app/window/number_field.h"
#include "core/io/point_io.h"

namespace stipple {

namespace {

constexpr int kDragStep = 6;  // pixels between the moves of a drag

bool isSamePicture(const View& a, const View& b) {
  return a.eye == b.eye && a.viewFromWorld == b.viewFromWorld && a.projection == b.projection &&
         a.focalPx == b.focalPx && a.width == b.width && a.height == b.height;
}

}  // namespace

void WindowTest::SetUp() {
  QSettings().clear();
  startWindow();
}

void WindowTest::TearDown() {
  EXPECT_EQ(awaited_, 0) << "a dialog that the test waited for never opened";
  endWindow();
}

void WindowTest::startWindow(ViewportKind kind) {
  endWindow();
  std::vector<std::filesystem::path> folders = pluginFolders();
  folders.push_back(std::filesystem::path(STIPPLE_BINARY_DIR) / "tests/good_plugins");
  settings_ = std::make_unique<Settings>();
  const Theme theme = settings_->theme().value_or(systemTheme());
  applyTheme(*qApp, theme);
  workbench_ = std::make_unique<Workbench>(loadPlugins(folders), Workbench::Options{});
  QObject::connect(workbench_.get(), &Workbench::said,
                   [this](const QString& sentence) { said_.push_back(sentence); });
  window_ = std::make_unique<MainWindow>(*workbench_, *settings_,
                                         MainWindow::Options{.viewport = kind, .keepsQuiet = true});
  view().setTheme(theme);
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), 60'000));
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), 60'000));
  view().viewport().widget().setFocus();
}

void WindowTest::endWindow() {
  window_.reset();
  workbench_.reset();
  settings_.reset();
}

bool WindowTest::waitFor(const char* what, const std::function<bool()>& holds, int milliseconds) {
  const bool held = QTest::qWaitFor(holds, milliseconds);
  EXPECT_TRUE(held) << "never came: " << what;
  return held;
}

void WindowTest::waitUntilIdle() {
  waitFor("the end of the work", [this] { return !workbench_->isRunning() && !workbench_->task(); });
}

void WindowTest::waitForPicture() {
  waitFor("the picture", [this] {
    const auto notes = view().viewport().notes();
    const QSize size = view().viewport().widget().size();
    return notes && notes->isConverged &&
           isSamePicture(notes->view, scan().camera.view({size.width(), size.height()}));
  });
}

std::filesystem::path WindowTest::writeSphere(const std::string& name, Index count) {
  std::vector<Eigen::Vector3f> positions(count);
  std::vector<float> altitude(count);
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (Index i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), angle = golden * i;
    positions[i] = Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>();
    altitude[i] = positions[i].z();
  }
  PointSet sphere(positions);
  sphere.set("normal", positions);
  sphere.set("altitude", std::move(altitude));
  Progress progress;
  writePoints(folder_ / name, sphere, {}, progress);
  return folder_ / name;
}

OpenScan& WindowTest::open(const std::filesystem::path& path) {
  const std::size_t before = workbench_->scans().size();
  const auto surface = [this] {
    const auto notes = view().viewport().notes();
    return notes ? notes->surface : 0;
  };
  const std::uint64_t surfaceBefore = surface();
  answerFileDialog(path);
  key(Qt::Key_O, Qt::ControlModifier);
  waitFor("the scan", [&] { return workbench_->scans().size() == before + 1; });
  waitUntilIdle();
  waitFor("the first picture", [&] { return surface() != surfaceBefore; });
  waitForPicture();
  return scan();
}

QPoint WindowTest::center() {
  return view().viewport().widget().rect().center();
}

void WindowTest::press(const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers held) {
  QWidget& widget = view().viewport().widget();
  QTest::mousePress(window_->windowHandle(), button, held, widget.mapTo(window_.get(), at));
  lastMove_ = at;
}

void WindowTest::moveTo(const QPoint& at, Qt::KeyboardModifiers) {
  QWidget& widget = view().viewport().widget();
  QTest::mouseMove(window_->windowHandle(), widget.mapTo(window_.get(), at));
  lastMove_ = at;
}

void WindowTest::release(const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers held) {
  QWidget& widget = view().viewport().widget();
  QTest::mouseRelease(window_->windowHandle(), button, held, widget.mapTo(window_.get(), at));
}

void WindowTest::drag(const std::vector<QPoint>& places, Qt::KeyboardModifiers held, Qt::MouseButton button) {
  press(places.front(), button, held);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const QPoint from = places[i - 1], way = places[i] - from;
    const int steps = std::max(1, way.manhattanLength() / kDragStep);
    for (int step = 1; step <= steps; ++step) moveTo(from + way * step / steps, held);
  }
  release(places.back(), button, held);
}

void WindowTest::turnWheel(const QPoint& at, int steps, Qt::KeyboardModifiers held) {
  QWidget& widget = view().viewport().widget();
  QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, held, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&widget, &event);
}

// There is no window manager on the screen: the focus of a window or dialog that went comes back late.
void WindowTest::activate() {
  if (window_->isActiveWindow()) return;
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), 60'000));
}

void WindowTest::key(Qt::Key key, Qt::KeyboardModifiers held) {
  activate();
  QTest::keyClick(window_->windowHandle(), key, held);
}

void WindowTest::typeInto(QWidget& field, const QString& text) {
  activate();
  QTest::mouseDClick(&field, Qt::LeftButton, {}, field.rect().center());
  QWidget* editor = QApplication::focusWidget();
  ASSERT_TRUE(editor && (editor == &field || field.isAncestorOf(editor)));
  QTest::keyClicks(editor, text);
  QTest::keyClick(editor, Qt::Key_Return);
}

void WindowTest::click(QWidget& widget) {
  QTest::mouseClick(&widget, Qt::LeftButton);
}

void WindowTest::choose(const std::string& command) {
  QAction* action = window_->commands().action(command);
  ASSERT_NE(action, nullptr) << command;
  ASSERT_TRUE(action->isEnabled()) << command;
  action->trigger();
}

void WindowTest::chooseOperator(const std::string& id,
                                const std::vector<std::pair<const char*, int>>& numbers) {
  choose("operator_" + id);
  QApplication::processEvents();  // the fields appear
  for (const auto& [parameter, number] : numbers) {
    NumberField* field = nullptr;
    for (NumberField* candidate : window_->findChildren<NumberField*>(parameter)) {
      if (candidate->isVisibleTo(window_.get())) field = candidate;
    }
    ASSERT_NE(field, nullptr) << parameter;
    typeInto(*field, QString::number(number));
  }
  view().viewport().widget().setFocus();
}

void WindowTest::clickHistory(int row) {
  QListWidget& list = history();
  ASSERT_LT(row, list.count());
  list.scrollToItem(list.item(row));
  QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(row)).center());
}

QListWidget& WindowTest::history() {
  return *find<QListWidget>("history");
}

void WindowTest::whenDialogOpens(std::function<void(QWidget& dialog)> drive) {
  ++awaited_;
  pollForDialog(std::move(drive));
}

void WindowTest::pollForDialog(std::function<void(QWidget&)> drive) {
  QTimer::singleShot(20, window_.get(), [this, drive = std::move(drive)] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (!dialog || !dialog->isVisible()) return pollForDialog(drive);
    --awaited_;
    ++driven_;
    drive(*dialog);
  });
}

void WindowTest::answerFileDialog(const std::filesystem::path& path) {
  whenDialogOpens([path](QWidget& dialog) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    const auto* buttons = dialog.findChild<QDialogButtonBox*>();
    ASSERT_TRUE(name && buttons) << "no file dialog";
    name->setText(QString::fromStdString(path.string()));
    QPushButton* accepts = buttons->button(QDialogButtonBox::Open);
    if (!accepts) accepts = buttons->button(QDialogButtonBox::Save);
    click(*accepts);
  });
}

glm::vec2 WindowTest::pixelOf(Index row) {
  const QSize size = view().viewport().widget().size();
  const View shown = scan().camera.view({size.width(), size.height()});
  const Eigen::Vector3f& p = points().positions()[row];
  return shown.toPixels(shown.toView({p.x(), p.y(), p.z()}));
}

}  // namespace stipple
