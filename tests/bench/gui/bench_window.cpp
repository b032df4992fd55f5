#include "tests/bench/gui/bench_window.h"

#include <QApplication>
#include <QTest>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/io/point_io.h"

namespace stipple {

namespace {

constexpr int kPatience = 600'000, kWatch = 2, kAsk = 20;  // milliseconds

}  // namespace

double Times::share(double part) const {
  if (values.empty()) return std::nan("");
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1) + 0.5)];
}

Watchdog::Watchdog() {
  connect(&timer_, &QTimer::timeout, this, [this] {
    blocked_.values.push_back(std::max(0.0, static_cast<double>(since_.nsecsElapsed()) / 1e6 - kWatch)),
        since_.restart();
  });
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kWatch);
  since_.start();
}

/// Notes what the picture was that was painted last.
class BenchWindow::PaintCounter : public QObject {
 public:
  explicit PaintCounter(ViewController& view) : view_(view) {
    view.viewport().widget().installEventFilter(this);
  }

  const FrameNotes& notes() const { return notes_; }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Paint) return false;
    // When this arrives, the widget has painted.
    if (const auto notes = view_.viewport().notes())
      QTimer::singleShot(0, this, [this, notes] { notes_ = *notes; });
    return false;
  }

 private:
  ViewController& view_;
  FrameNotes notes_;
};

BenchWindow::BenchWindow(ViewportKind kind) {
  applyTheme(*qApp, Theme::kDark);
  workbench_ = std::make_unique<Workbench>(loadPlugins(pluginFolders()), Workbench::Options{});
  window_ = std::make_unique<MainWindow>(*workbench_, settings_,
                                         MainWindow::Options{.viewport = kind, .keepsQuiet = true});
  view().setTheme(Theme::kDark);
  QObject::connect(&view(), &ViewController::pictureChanged, [this] { ++pictures_; });
  painted_ = std::make_unique<PaintCounter>(view());
  window_->setWindowState(Qt::WindowNoState);
  window_->resize(1600, 1000);
  window_->show();
}

BenchWindow::~BenchWindow() {
  painted_.reset();
  window_.reset();
}

double BenchWindow::waitFor(const std::function<bool()>& holds) {
  QElapsedTimer timer;
  timer.start();
  QTimer alarm;  // asks again even if nothing happens; with a time limit, processEvents would not sleep
  alarm.start(kAsk);
  while (!holds() && timer.elapsed() < kPatience) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

double BenchWindow::waitForPaintedChanges() {
  return waitFor([this] { return painted_->notes().revision >= scan().shownRevision; });
}

double BenchWindow::waitForPaintedView() {
  const View wanted = scan().camera.view({1, 1});
  return waitFor([&] {
    const View& shown = painted_->notes().view;
    return shown.eye == wanted.eye && shown.viewFromWorld == wanted.viewFromWorld;
  });
}

void BenchWindow::waitUntilQuiet() {
  waitFor([this] { return !workbench_->task() && !workbench_->isRunning(); });
  waitFor([this] {
    const auto notes = view().viewport().notes();
    return notes && notes->isConverged;
  });
}

double BenchWindow::open(const std::filesystem::path& path) {
  QElapsedTimer timer;
  timer.start();
  const std::size_t before = pictures_;
  workbench_->open(path);
  waitFor([&] { return workbench_->current() && pictures_ > before; });
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

void BenchWindow::press(const QPoint& at) {
  QTest::mousePress(window_->windowHandle(), Qt::LeftButton, {},
                    view().viewport().widget().mapTo(window_.get(), at));
}

void BenchWindow::moveTo(const QPoint& at) {
  QTest::mouseMove(window_->windowHandle(), view().viewport().widget().mapTo(window_.get(), at));
}

void BenchWindow::release(const QPoint& at) {
  QTest::mouseRelease(window_->windowHandle(), Qt::LeftButton, {},
                      view().viewport().widget().mapTo(window_.get(), at));
}

void writeTorus(const std::filesystem::path& path, std::size_t count) {
  constexpr double kTube = 0.45;
  std::vector<Eigen::Vector3f> positions(count), normals(count);
  std::vector<Rgba8> colors(count);
  const double golden = (std::sqrt(5.0) - 1) / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double v = 2 * std::numbers::pi * std::fmod(golden * static_cast<double>(i), 1.0);
    const Eigen::Vector3d out(std::cos(u), std::sin(u), 0),
        normal = std::cos(v) * out + std::sin(v) * Eigen::Vector3d::UnitZ();
    positions[i] = (out + kTube * normal).cast<float>();
    normals[i] = normal.cast<float>();
    colors[i] = {static_cast<std::uint8_t>(128 + 100 * std::cos(9 * u)), 150,
                 static_cast<std::uint8_t>(128 + 100 * std::sin(5 * v)), 255};
  }
  PointSet torus(std::move(positions));
  torus.set("normal", std::move(normals));
  torus.set("color", std::move(colors));
  Progress progress;
  writePoints(path, torus, {}, progress);
}

}  // namespace stipple
