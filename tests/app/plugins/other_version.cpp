// Written for a plugin interface that does not exist.
#include "plugins/api/plugin.h"

namespace {

constexpr stipple::PluginHeader makeHeader() {
  stipple::PluginHeader header{.magic = {'S', 't', 'i', 'p', 'p', 'l', 'e', '\n'},
                               .apiVersion = stipple::kPluginApiVersion,
                               .abi = stipple::currentAbi(),
                               .id = "other version",
                               .version = "1.0"};
  header.apiVersion = 99;
  return header;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const stipple::PluginHeader stipple_plugin_header;
extern "C" const stipple::PluginHeader stipple_plugin_header = makeHeader();
extern "C" __attribute__((visibility("default"))) void stipple_plugin_register(stipple::Registry&) {}
