#include "tests/gui/robot.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QPixmap>
#include <QScreen>
#include <QTest>

namespace stipple {

namespace {

constexpr int kPatience = 120'000;  // milliseconds, for machines that do much else
constexpr int kLook = 50;           // milliseconds between looks

int xdotool(const QStringList& words) {
  QProcess process;
  process.setStandardOutputFile(QProcess::nullDevice());
  process.start("xdotool", words);
  EXPECT_TRUE(process.waitForStarted()) << "xdotool is in the Debian package xdotool";
  process.waitForFinished(kPatience);
  return process.exitCode();
}

QStringList placeWords(const QPoint& at) {
  return {"mousemove", QString::number(at.x()), QString::number(at.y())};
}

}  // namespace

Robot::Robot(const std::filesystem::path& program, const QStringList& arguments) {
  program_.setProcessChannelMode(QProcess::ForwardedChannels);
  program_.start(QString::fromStdString(program.string()), arguments);
  program_.waitForStarted();
}

Robot::~Robot() {
  if (!isRunning()) return;
  program_.kill();
  program_.waitForFinished();
}

int Robot::waitForEnd() {
  const bool hasEnded = !isRunning() || program_.waitForFinished(kPatience);
  return hasEnded && program_.exitStatus() == QProcess::NormalExit ? program_.exitCode() : -1;
}

bool Robot::waitUntil(const std::function<bool()>& holds) {
  QElapsedTimer timer;
  timer.start();
  while (!holds()) {
    if (timer.elapsed() > kPatience) return false;
    QTest::qWait(kLook);
  }
  return true;
}

bool Robot::showsWindow(const QString& title) {
  return xdotool({"search", "--onlyvisible", "--name", "^" + title + "$"}) == 0;
}

bool Robot::waitForWindow(const QString& title) {
  return waitUntil([&] { return showsWindow(title); });
}

void Robot::focus(const QString& title) {
  xdotool({"search", "--onlyvisible", "--name", "^" + title + "$", "windowfocus"});
}

void Robot::moveToCorner(const QString& title) {
  xdotool({"search", "--onlyvisible", "--name", "^" + title + "$", "windowmove", "0", "0"});
}

QImage Robot::screen() {
  return QGuiApplication::primaryScreen()->grabWindow(0).toImage();
}

void Robot::key(const QString& keys) {
  xdotool({"key", keys});
}

void Robot::type(const QString& text) {
  xdotool({"type", "--delay", "5", text});
}

void Robot::moveTo(const QPoint& at) {
  xdotool(placeWords(at));
}

void Robot::click(const QPoint& at) {
  moveTo(at);
  xdotool({"click", "1"});
}

void Robot::drag(const std::vector<QPoint>& places, const QPoint& rest) {
  moveTo(places.front());
  xdotool({"mousedown", "1"});
  for (const QPoint& place : places) moveTo(place);
  xdotool({"mouseup", "1"});
  moveTo(rest);
}

}  // namespace stipple
