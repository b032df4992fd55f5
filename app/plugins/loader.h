#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/plugins/sentinel.h"
#include "plugins/api/registry.h"

namespace stipple {

/// The operators of all plugins that could be loaded, and one sentence for each file that could not.
struct LoadedPlugins {
  Registry registry;
  std::vector<std::string> warnings;
  std::map<std::string, std::filesystem::path> files;  ///< of each operator, by id
};

/// Where plugins are looked for: the folder beside the running program, then those named in
/// STIPPLE_PLUGIN_PATH (separated by colons).
std::vector<std::filesystem::path> pluginFolders();

/// Loads every file of the folders, by name within a folder; hidden files are passed over. A file that is not
/// a plugin for this program harms nothing else. Libraries stay loaded until the program ends. With a
/// sentinel, plugins that are off are left out, and others are watched while they load.
LoadedPlugins loadPlugins(const std::vector<std::filesystem::path>& folders,
                          PluginSentinel* sentinel = nullptr);

}  // namespace stipple
