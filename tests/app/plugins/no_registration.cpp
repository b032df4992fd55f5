// Has a header and registers nothing.
#include "plugins/api/plugin.h"

namespace {

constexpr stipple::PluginHeader makeHeader() {
  stipple::PluginHeader header{.magic = {'S', 't', 'i', 'p', 'p', 'l', 'e', '\n'},
                               .apiVersion = stipple::kPluginApiVersion,
                               .abi = stipple::currentAbi(),
                               .id = "no registration",
                               .version = "1.0"};
  return header;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const stipple::PluginHeader stipple_plugin_header;
extern "C" const stipple::PluginHeader stipple_plugin_header = makeHeader();
