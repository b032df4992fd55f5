#pragma once

#include <QByteArray>
#include <QStringList>
#include <filesystem>
#include <optional>

#include "app/window/theme.h"

namespace stipple {

/// What lasts from one start to the next: the user's choices, in the user's configuration folder.
class Settings {
 public:
  std::optional<Theme> theme() const;  ///< none: as the desktop
  void setTheme(std::optional<Theme> theme);
  QStringList recentFiles() const;
  void addRecentFile(const QString& path);
  QByteArray geometry() const;
  QByteArray layout() const;
  void setWindow(const QByteArray& geometry, const QByteArray& layout);
  bool wasStartedBefore() const;
  void noteStart();
  std::size_t undoBytes() const;  ///< 512 MB unless chosen otherwise
  QString folder() const;         ///< that a file was last chosen in
  void setFolder(const QString& folder);
  QString recipeFolder() const;  ///< the same for recipes; at first that of those that come with the program
  void setRecipeFolder(const QString& folder);
};

/// A file or folder that comes with the program, by its place among the resources.
QString resourcePath(const QString& place);

/// Folders of the user for what Stipple keeps: undo steps that left memory, journals, which plugins are off.
std::filesystem::path spillFolder();
std::filesystem::path journalFolder();
std::filesystem::path stateFolder();

}  // namespace stipple
