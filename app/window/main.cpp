#include <fmt/format.h>

#include <QApplication>
#include <QTimer>
#include <cstdio>
#include <filesystem>

#include "app/plugins/loader.h"
#include "app/window/main_window.h"
#include "app/window/settings.h"
#include "app/window/theme.h"
#include "app/window/workbench.h"

namespace stipple {
namespace {

constexpr int kUsage = 2;

struct Arguments {
  QStringList files;
  ViewportKind viewport = ViewportKind::kAuto;
};

constexpr const char* kHelp = R"(stipple [--backend auto|cpu|gl] [FILE...]
Opens the files, or the sample where none is named.
)";

// Nothing where the program has said what there was to say.
std::optional<Arguments> readArguments(const QStringList& given, int& status) {
  Arguments arguments;
  for (int i = 1; i < given.size(); ++i) {
    const QString& word = given[i];
    if (word == "--help" || word == "-h") {
      fmt::print("{}", kHelp);
      return {};
    }
    if (word == "--version") {
      fmt::print("stipple {}\n", STIPPLE_VERSION);
      return {};
    }
    if (word == "--backend" && i + 1 < given.size()) {
      const QString name = given[++i];
      const bool isKnown = name == "auto" || name == "cpu" || name == "gl";
      arguments.viewport = name == "gl"    ? ViewportKind::kGl
                           : name == "cpu" ? ViewportKind::kCpu
                                           : ViewportKind::kAuto;
      if (isKnown) continue;
    }
    if (word.startsWith('-')) {
      fmt::print(stderr, "stipple: unknown option '{}'; stipple --help tells what there is\n",
                 word.toStdString());
      status = kUsage;
      return {};
    }
    arguments.files << word;
  }
  return arguments;
}

void openFirst(Workbench& workbench, const QStringList& files) {
  if (files.isEmpty()) return workbench.openSample();
  for (const QString& file : files) workbench.open(std::filesystem::absolute(file.toStdString()));
}

int runWindow(QApplication& application, const Arguments& arguments) {
  Settings settings;
  const Theme theme = settings.theme().value_or(systemTheme());
  applyTheme(application, theme);
  const bool keepsQuiet = !arguments.files.isEmpty();
  const auto sentinel = std::make_shared<PluginSentinel>(stateFolder());
  Workbench workbench(loadPlugins(pluginFolders(), sentinel.get()),
                      {.history = {.memoryCap = settings.undoBytes(), .spillFolder = spillFolder()},
                       .journals = journalFolder(),
                       .sentinel = sentinel});
  MainWindow window(workbench, settings, {.viewport = arguments.viewport, .keepsQuiet = keepsQuiet});
  window.view().setTheme(theme);
  window.show();
  openFirst(workbench, arguments.files);
  settings.noteStart();
  return QApplication::exec();
}

}  // namespace
}  // namespace stipple

int main(int argc, char** argv) {
  QApplication::setApplicationName("Stipple");
  QApplication::setOrganizationName("Stipple");
  QApplication::setApplicationVersion(STIPPLE_VERSION);
  QStringList given;
  for (int i = 0; i < argc; ++i) given << QString::fromLocal8Bit(argv[i]);
  int status = 0;
  // Before the window system is asked for, so that help works without one.
  const auto arguments = stipple::readArguments(given, status);
  if (!arguments) return status;
  QApplication application(argc, argv);
  return stipple::runWindow(application, *arguments);
}
