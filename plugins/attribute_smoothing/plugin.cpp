#include "plugins/api/plugin.h"
#include "plugins/attribute_smoothing/attribute_smoothing.h"

STIPPLE_PLUGIN("attribute_smoothing", "1.0") {
  registry.add(stipple::makeAttributeSmoothing());
}
