#include "plugins/api/plugin.h"
#include "plugins/texture_synthesis/texture_synthesis.h"

STIPPLE_PLUGIN("texture_synthesis", "1.0") {
  registry.add(stipple::makeTextureSynthesis());
}
