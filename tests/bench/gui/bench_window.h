#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "app/window/main_window.h"
#include "app/window/workbench.h"

namespace stipple {

/// Milliseconds of many tries. The machine may do much else: the least is what it can do.
struct Times {
  std::vector<double> values = {};
  double least() const { return share(0); }
  double median() const { return share(0.5); }
  double worst() const { return share(1); }
  double share(double part) const;  ///< 0.99: one in a hundred is above it
};

/// How long the event loop does not come by, looked at every 2 ms.
class Watchdog : public QObject {
 public:
  Watchdog();
  Times blocked() const { return blocked_; }

 private:
  QTimer timer_;
  QElapsedTimer since_;
  Times blocked_;
};

/// The window of the program, 1600 x 1000, driven from within.
class BenchWindow {
 public:
  explicit BenchWindow(ViewportKind kind);
  ~BenchWindow();

  Workbench& workbench() { return *workbench_; }
  MainWindow& window() { return *window_; }
  ViewController& view() { return window_->view(); }
  OpenScan& scan() { return *workbench_->current(); }

  /// Milliseconds until it holds, events passing.
  static double waitFor(const std::function<bool()>& holds);
  /// Milliseconds until a picture with all changes of the scan is on the screen.
  double waitForPaintedChanges();
  /// Until one from the present camera is.
  double waitForPaintedView();
  /// So many until now.
  std::size_t pictures() const { return pictures_; }
  void waitUntilQuiet();
  double open(const std::filesystem::path& path);

  QPoint center() { return view().viewport().widget().rect().center(); }
  void press(const QPoint& at);
  void moveTo(const QPoint& at);
  void release(const QPoint& at);

 private:
  class PaintCounter;
  Settings settings_;
  std::unique_ptr<Workbench> workbench_;
  std::unique_ptr<MainWindow> window_;
  std::unique_ptr<PaintCounter> painted_;
  std::size_t pictures_ = 0;
};

/// A torus of `count` points with normals and colors in a PLY file.
void writeTorus(const std::filesystem::path& path, std::size_t count);

}  // namespace stipple
