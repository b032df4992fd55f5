#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "plugins/api/build_hash.h"
#include "plugins/api/registry.h"

namespace stipple {

/// What must be the same in a plugin and its host, so that they may exchange C++ objects.
struct PluginAbi {
  std::uint32_t compiler;         ///< 1000 * (1 GCC, 2 Clang) + major version
  std::uint32_t standardLibrary;  ///< 10 * (1 libstdc++, 2 libc++) + ABI; + 100 with checked containers
  std::uint64_t headers;          ///< hash of the core version and all public headers
  std::uint32_t eigenAlignment;   ///< EIGEN_MAX_ALIGN_BYTES
  std::uint32_t assertions;       ///< 1 without NDEBUG
};

/// The first thing a host reads of a plugin. `magic` and `apiVersion` never change their place.
struct PluginHeader {
  char magic[8];
  std::uint32_t apiVersion;
  PluginAbi abi;
  const char* id;  ///< name of the plugin, not of its operators
  const char* version;
};

inline constexpr char kPluginMagic[8] = {'S', 't', 'i', 'p', 'p', 'l', 'e', '\n'};
inline constexpr std::uint32_t kPluginApiVersion = 1;

/// The ABI of the code that calls it.
constexpr PluginAbi currentAbi() {
  PluginAbi abi{.compiler = 0,
                .standardLibrary = 0,
                .headers = kPublicHeadersHash,
                .eigenAlignment = EIGEN_MAX_ALIGN_BYTES,
                .assertions = 1};
#if defined(__clang__)
  abi.compiler = 2000 + __clang_major__;
#elif defined(__GNUC__)
  abi.compiler = 1000 + __GNUC__;
#endif
#if defined(_LIBCPP_VERSION)
  abi.standardLibrary = 20 + _LIBCPP_ABI_VERSION;
#elif defined(__GLIBCXX__)
  abi.standardLibrary = 10 + _GLIBCXX_USE_CXX11_ABI;
#endif
#if defined(_GLIBCXX_DEBUG)
  abi.standardLibrary += 100;
#endif
#if defined(NDEBUG)
  abi.assertions = 0;
#endif
  return abi;
}

}  // namespace stipple

/// Stands once in a plugin, followed by the body of a function that adds the plugin's operators to
/// `registry`:
///   STIPPLE_PLUGIN("fairing", "1.0") { registry.add(makeFairing()); }
#define STIPPLE_PLUGIN(pluginId, pluginVersion)                                                              \
  extern "C" __attribute__((visibility("default"))) const stipple::PluginHeader stipple_plugin_header;       \
  extern "C" const stipple::PluginHeader stipple_plugin_header = {{'S', 't', 'i', 'p', 'p', 'l', 'e', '\n'}, \
                                                                  stipple::kPluginApiVersion,                \
                                                                  stipple::currentAbi(),                     \
                                                                  pluginId,                                  \
                                                                  pluginVersion};                            \
  extern "C" __attribute__((visibility("default"))) void stipple_plugin_register(stipple::Registry& registry)
