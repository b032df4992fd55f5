#include "app/plugins/loader.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "plugins/api/plugin.h"

namespace stipple {

namespace {

namespace fs = std::filesystem;

using RegisterFunction = void (*)(Registry&);

bool isElf(const fs::path& file) {
  std::array<char, 4> magic{};
  std::ifstream(file, std::ios::binary).read(magic.data(), magic.size());
  return std::memcmp(magic.data(),
                     "\x7f"
                     "ELF",
                     magic.size()) == 0;
}

std::string lastLinkerError(const fs::path& file) {
  const char* error = dlerror();
  std::string message = error ? error : "the linker gave no reason";
  const std::string prefix = file.string() + ": ";
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

std::string describeCompiler(std::uint32_t compiler) {
  const char* name = compiler / 1000 == 1 ? "GCC" : compiler / 1000 == 2 ? "Clang" : "compiler";
  return fmt::format("{} {}", name, compiler % 1000);
}

void checkAbi(const PluginAbi& plugin) {
  const PluginAbi host = currentAbi();
  if (plugin.compiler != host.compiler) {
    throw InvalidInput(fmt::format("it was built with {}, this program with {}",
                                   describeCompiler(plugin.compiler), describeCompiler(host.compiler)));
  }
  if (plugin.standardLibrary != host.standardLibrary) {
    throw InvalidInput("it was built with another standard library than this program");
  }
  if (plugin.headers != host.headers) {
    throw InvalidInput("it was built against the headers of another version of Stipple");
  }
  if (plugin.eigenAlignment != host.eigenAlignment) {
    throw InvalidInput(
        fmt::format("it was built with {} bytes as the largest alignment of Eigen, this program with {}",
                    plugin.eigenAlignment, host.eigenAlignment));
  }
  if (plugin.assertions != host.assertions) {
    throw InvalidInput(fmt::format("it was built {} assertions, this program {}",
                                   plugin.assertions ? "with" : "without",
                                   host.assertions ? "with" : "without"));
  }
}

void* requireSymbol(void* library, const char* name) {
  void* symbol = dlsym(library, name);
  if (!symbol) throw InvalidInput(fmt::format("it is not a plugin of Stipple: it has no symbol {}", name));
  return symbol;
}

// The header's fields beyond the API version are read only where magic and version are ours.
void checkHeader(const PluginHeader& header) {
  if (std::memcmp(header.magic, kPluginMagic, sizeof kPluginMagic) != 0) {
    throw InvalidInput("it is not a plugin of Stipple: its header does not begin with the magic bytes");
  }
  if (header.apiVersion != kPluginApiVersion) {
    throw InvalidInput(
        fmt::format("it is written for version {} of the plugin interface, this program has version {}",
                    header.apiVersion, kPluginApiVersion));
  }
  checkAbi(header.abi);
}

// The operators of one file. Throws with the reason where there are none to be had.
Registry loadPlugin(const fs::path& file) {
  if (!isElf(file)) throw InvalidInput("it is not a shared library");
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw InvalidInput("it cannot be loaded: " + lastLinkerError(file));
  checkHeader(*static_cast<const PluginHeader*>(requireSymbol(library, "stipple_plugin_header")));
  const auto registerOperators =
      reinterpret_cast<RegisterFunction>(requireSymbol(library, "stipple_plugin_register"));
  Registry registry;
  registerOperators(registry);
  return registry;
}

std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
    std::error_code vanished;
    const bool hidden = entry.path().filename().string().starts_with('.');
    if (!hidden && entry.is_regular_file(vanished)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::vector<fs::path> pluginFolders() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  std::vector<fs::path> folders = {program.parent_path().parent_path() / STIPPLE_PLUGIN_DIR};
  if (const char* more = std::getenv("STIPPLE_PLUGIN_PATH")) {
    std::istringstream list(more);
    for (std::string folder; std::getline(list, folder, ':');) {
      if (!folder.empty()) folders.emplace_back(folder);
    }
  }
  return folders;
}

namespace {

void takePlugin(LoadedPlugins& loaded, const fs::path& file, PluginSentinel* sentinel) {
  if (sentinel && sentinel->isOff(file))
    throw InvalidInput(
        "it was at work when the program broke down; it can be turned on again under Help, Plugins");
  const auto watch = sentinel ? sentinel->watch(file) : nullptr;
  Registry registry = loadPlugin(file);
  std::vector<std::string> ids;
  for (const auto& held : registry.operators()) ids.push_back(held->description().id);
  loaded.registry.merge(std::move(registry));
  for (const std::string& id : ids) loaded.files[id] = file;
}

}  // namespace

LoadedPlugins loadPlugins(const std::vector<fs::path>& folders, PluginSentinel* sentinel) {
  LoadedPlugins loaded;
  for (const fs::path& folder : folders) {
    for (const fs::path& file : filesOf(folder)) {
      const auto leaveOut = [&](std::string_view reason) {
        loaded.warnings.push_back(fmt::format("plugin {} was left out: {}", file.string(), reason));
      };
      try {
        takePlugin(loaded, fs::absolute(file).lexically_normal(), sentinel);
      } catch (const std::exception& error) {
        leaveOut(error.what());
      } catch (...) {
        leaveOut("it threw something that is not a std::exception");
      }
    }
  }
  return loaded;
}

}  // namespace stipple
