#include "plugins/api/plugin.h"
#include "plugins/bump_mapping/bump_mapping.h"

STIPPLE_PLUGIN("bump_mapping", "1.0") {
  registry.add(stipple::makeBumpMapping());
}
