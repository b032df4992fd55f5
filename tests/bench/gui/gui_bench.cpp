// What the hand feels: gui_bench [cpu|gl] [POINTS] [MANY_POINTS] opens the window with scans of so many
// points (a million, ten millions), does what an artist does and prints how long it takes until it is seen.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "tests/bench/gui/bench_window.h"
#include "tests/gui/virtual_screen.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

constexpr int kDabs = 1000, kDragSteps = 200, kEdits = 10;
constexpr double kRunSeconds = 60;

void printHead() {
  fmt::print("{:<52}{:>10}{:>10}{:>10}{:>10}\n", "milliseconds", "least", "median", "99 %", "worst");
}

void print(const char* what, const Times& times) {
  fmt::print("{:<52}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}\n", what, times.least(), times.median(),
             times.share(0.99), times.worst());
  std::fflush(stdout);
}

template <class Action>
double timeOf(Action&& action) {
  QElapsedTimer timer;
  timer.start();
  action();
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

// Along a spiral on the surface: the middle of the picture may be the hole of the torus.
QPoint placeOnRing(BenchWindow& bench, int step) {
  const double angle = 0.045 * step, radius = 0.27 * bench.view().viewport().widget().height();
  return bench.center() +
         QPoint(std::lround(radius * std::cos(angle)), std::lround(0.9 * radius * std::sin(angle)));
}

void measureDabs(BenchWindow& bench) {
  bench.view().paintAttribute("paint", {1});
  bench.waitFor([&] { return bench.scan().hasDistance(); });
  bench.waitUntilQuiet();
  Times times;
  bench.press(placeOnRing(bench, 0));
  for (int step = 1; static_cast<int>(times.values.size()) <= kDabs && step < 4 * kDabs; ++step) {
    const std::uint64_t before = bench.scan().document.revision();
    QElapsedTimer timer;
    timer.start();
    bench.moveTo(placeOnRing(bench, step));
    if (bench.scan().document.revision() == before) continue;
    bench.waitForPaintedChanges();
    times.values.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
  }
  bench.release(placeOnRing(bench, 0));
  bench.view().setTool(Tool::kOrbit);
  // It makes the attribute, and all colors anew.
  print("first dab of a new attribute to painted picture", Times{{times.values.front()}});
  times.values.erase(times.values.begin());
  print(fmt::format("dab to painted picture ({} dabs)", times.values.size()).c_str(), times);
}

void measureUndo(BenchWindow& bench) {
  Times calls, undone, redone;
  bench.workbench().flipNormals();
  bench.waitUntilQuiet();
  for (int i = 0; i < kEdits; ++i) {
    const double undo = timeOf([&] { bench.workbench().undo(); });
    undone.values.push_back(undo + bench.waitForPaintedChanges());
    const double redo = timeOf([&] { bench.workbench().redo(); });
    redone.values.push_back(redo + bench.waitForPaintedChanges());
    calls.values.insert(calls.values.end(), {undo, redo});
  }
  bench.workbench().undo();
  print("undo of all normals to picture", undone);
  print("redo of all normals to picture", redone);
  print("  of that in the event loop", calls);
}

// Turns the view for a while, a step for each picture, and notes how long each takes.
Times turn(BenchWindow& bench, double seconds, const std::function<bool()>& goesOn) {
  Times times;
  QElapsedTimer all;
  all.start();
  QPoint at = bench.center();
  bench.press(at);
  for (int step = 1; goesOn() && static_cast<double>(all.elapsed()) < 1000 * seconds; ++step) {
    const QPoint last = at;
    at = bench.center() +
         QPoint(std::lround(200 * std::sin(0.05 * step)), std::lround(60 * std::sin(0.03 * step)));
    if (at == last) continue;  // nothing to draw
    QElapsedTimer timer;
    timer.start();
    bench.moveTo(at);
    bench.waitForPaintedView();
    times.values.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
  }
  bench.release(at);
  return times;
}

void measureProcess(BenchWindow& bench) {
  Workbench& workbench = bench.workbench();
  bench.view().setTool(Tool::kOrbit);
  Times states;
  // A state is seen at the latest with the second picture from then: the next may have been begun before.
  struct Waiting {
    QElapsedTimer since;
    std::size_t pictures;
  };
  std::optional<Waiting> waiting;
  QObject guard;
  QObject::connect(&workbench, &Workbench::previewChanged, &guard, [&] {
    if (waiting) return;
    waiting.emplace();
    waiting->since.start();
    waiting->pictures = bench.pictures();
  });
  QObject::connect(&bench.view(), &ViewController::pictureChanged, &guard, [&] {
    if (!waiting || bench.pictures() < waiting->pictures + 2) return;
    states.values.push_back(static_cast<double>(waiting->since.nsecsElapsed()) / 1e6);
    waiting.reset();
  });
  const Watchdog watchdog;
  workbench.run(makeInvocation(workbench.registry(), "segmentation"));
  const Times camera = turn(bench, kRunSeconds, [&] { return workbench.isRunning(); });
  const Times blocked = watchdog.blocked();
  print("event loop blocked while the segmentation runs", blocked);
  print("camera: mouse to picture meanwhile", camera);
  fmt::print("{:<52}{:>20.1f}\n", "  pictures a second", 1000 / camera.median());
  print(fmt::format("intermediate state to pixels, at most ({} states)", states.values.size()).c_str(),
        states);
  workbench.cancel();
  bench.waitUntilQuiet();
}

// At several places of the run: finding neighbors, making matrices, factoring them.
void measureCancel(BenchWindow& bench) {
  Workbench& workbench = bench.workbench();
  Times times;
  for (const double seconds : {0.5, 2.0, 5.0, 10.0}) {
    workbench.run(makeInvocation(workbench.registry(), "segmentation"));
    turn(bench, seconds, [&] { return workbench.isRunning(); });
    if (!workbench.isRunning()) break;
    times.values.push_back(timeOf([&] {
      workbench.cancel();
      workbench.flipNormals();
    }));
    bench.waitUntilQuiet();
  }
  print("cancel until an edit of all points is done", times);
}

void measureStart(ViewportKind kind) {
  Times times;
  for (int i = 0; i < 5; ++i) {
    times.values.push_back(timeOf([&] {
      BenchWindow bench(kind);
      bench.workbench().openSample();
      bench.waitFor([&] { return bench.workbench().current() && bench.pictures() > 0; });
    }));
  }
  print("window built to the first picture of the sample", times);
}

// Of the process since forgetPeak().
double peakMegabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
  }
  return std::nan("");
}

void forgetPeak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

void measureScan(ViewportKind kind, const std::filesystem::path& path, bool isEdited) {
  forgetPeak();
  BenchWindow bench(kind);
  bench.waitFor([&] { return bench.window().isVisible(); });
  print("file to first picture", Times{{bench.open(path)}});
  bench.waitUntilQuiet();
  print("drag: mouse to picture", turn(bench, 60, [steps = 0]() mutable { return steps++ < kDragSteps; }));
  if (isEdited) {
    measureDabs(bench);
    measureUndo(bench);
    measureProcess(bench);
    measureCancel(bench);
  }
  fmt::print("{:<52}{:>20.0f}\n", "most memory, MB", peakMegabytes());
}

// In a process of its own, so that the memory it takes is not counted.
std::filesystem::path writeElsewhere(const std::filesystem::path& folder, std::size_t count) {
  const std::filesystem::path path = folder / fmt::format("torus_{}.ply", count);
  const pid_t child = fork();
  if (child == 0) {
    writeTorus(path, count);
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  return path;
}

int benchWindow(int argc, char** argv) {
  const ViewportKind kind =
      argc > 1 && std::strcmp(argv[1], "gl") == 0 ? ViewportKind::kGl : ViewportKind::kCpu;
  const std::size_t some = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1'000'000;
  const std::size_t many = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 10'000'000;
  const TemporaryFolder folder;
  std::vector<std::pair<std::size_t, std::filesystem::path>> scans;
  for (const std::size_t count : {some, many}) {
    if (count > 0) scans.emplace_back(count, writeElsewhere(folder.path(), count));
  }
  if (!startVirtualScreen(1600, 1000)) return 1;
  QApplication application(argc, argv);
  printHead();
  measureStart(kind);
  for (const auto& [count, path] : scans) {
    fmt::print("\n{} points, {}, 1600 x 1000\n", count, kind == ViewportKind::kGl ? "gl" : "cpu");
    measureScan(kind, path, count == some);
  }
  return 0;
}

}  // namespace
}  // namespace stipple

int main(int argc, char** argv) {
  useEmptyHome();
  QApplication::setApplicationName("Stipple");
  QApplication::setOrganizationName("Stipple");
  return stipple::benchWindow(argc, argv);
}
