#include "app/window/settings.h"

#include <QCoreApplication>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>

namespace stipple {

namespace {

constexpr int kMostRecent = 10;

std::filesystem::path under(QStandardPaths::StandardLocation place, const char* name) {
  return std::filesystem::path(QStandardPaths::writableLocation(place).toStdString()) / name;
}

}  // namespace

std::optional<Theme> Settings::theme() const {
  const QString name = QSettings().value("theme").toString();
  if (name == "dark") return Theme::kDark;
  if (name == "light") return Theme::kLight;
  return {};
}

void Settings::setTheme(std::optional<Theme> theme) {
  if (!theme)
    QSettings().remove("theme");
  else
    QSettings().setValue("theme", *theme == Theme::kDark ? "dark" : "light");
}

QStringList Settings::recentFiles() const {
  return QSettings().value("recentFiles").toStringList();
}

void Settings::addRecentFile(const QString& path) {
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue("recentFiles", QStringList(files.mid(0, kMostRecent)));
}

QByteArray Settings::geometry() const {
  return QSettings().value("window/geometry").toByteArray();
}

QByteArray Settings::layout() const {
  return QSettings().value("window/layout").toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& layout) {
  QSettings settings;
  settings.setValue("window/geometry", geometry);
  settings.setValue("window/layout", layout);
}

bool Settings::wasStartedBefore() const {
  return QSettings().value("started").toBool();
}

void Settings::noteStart() {
  QSettings().setValue("started", true);
}

std::size_t Settings::undoBytes() const {
  return QSettings().value("undoMegabytes", 512).toULongLong() << 20;
}

QString Settings::folder() const {
  return QSettings().value("folder").toString();
}

void Settings::setFolder(const QString& folder) {
  QSettings().setValue("folder", folder);
}

QString Settings::recipeFolder() const {
  return QSettings().value("recipe_folder", resourcePath("recipes")).toString();
}

void Settings::setRecipeFolder(const QString& folder) {
  QSettings().setValue("recipe_folder", folder);
}

QString resourcePath(const QString& place) {
  const QDir programs(QCoreApplication::applicationDirPath());
  return QDir::cleanPath(programs.absoluteFilePath("../share/stipple/" + place));
}

std::filesystem::path spillFolder() {
  return under(QStandardPaths::CacheLocation, "undo");
}

std::filesystem::path journalFolder() {
  return under(QStandardPaths::AppLocalDataLocation, "journals");
}

std::filesystem::path stateFolder() {
  return under(QStandardPaths::AppLocalDataLocation, "state");
}

}  // namespace stipple
