#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plugins/api/registry.h"

namespace stipple {

/// The operators of all plugins that could be loaded, and one sentence for each file that could not.
struct LoadedPlugins {
  Registry registry;
  std::vector<std::string> warnings;
};

/// Where plugins are looked for: the folder beside the running program, then those named in
/// STIPPLE_PLUGIN_PATH (separated by colons).
std::vector<std::filesystem::path> pluginFolders();

/// Loads every file of the folders, by name within a folder; hidden files are passed over. A file that is not
/// a plugin for this program harms nothing else. Libraries stay loaded until the program ends.
LoadedPlugins loadPlugins(const std::vector<std::filesystem::path>& folders);

}  // namespace stipple
