#pragma once

#include <QImage>
#include <QPoint>
#include <QProcess>
#include <QString>
#include <filesystem>
#include <functional>
#include <vector>

namespace stipple {

/// Hands and eyes before the screen on which a program runs: mouse and keys by xdotool, what is seen by
/// looking at the screen and at the titles of windows. Knows nothing of the program.
class Robot {
 public:
  /// Starts the program; it ends with the robot.
  Robot(const std::filesystem::path& program, const QStringList& arguments);
  ~Robot();

  bool isRunning() { return program_.state() == QProcess::Running; }
  /// Waits for the end; its exit code, -1 where it does not come or a signal ended it.
  int waitForEnd();

  /// Looks again and again until it holds; false after minutes.
  static bool waitUntil(const std::function<bool()>& holds);
  /// A visible window has this title (a regular expression for all of it).
  static bool showsWindow(const QString& title);
  static bool waitForWindow(const QString& title);
  static void focus(const QString& title);
  static void moveToCorner(const QString& title);
  static QImage screen();
  static QColor colorAt(const QPoint& at) { return screen().pixelColor(at); }

  static void key(const QString& keys);
  static void type(const QString& text);
  static void moveTo(const QPoint& at);
  static void click(const QPoint& at);
  /// Down at the first place, then to the others, up at the last; then away to `rest`.
  static void drag(const std::vector<QPoint>& places, const QPoint& rest);

 private:
  QProcess program_;
};

}  // namespace stipple
