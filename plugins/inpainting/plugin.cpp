#include "plugins/api/plugin.h"
#include "plugins/inpainting/inpainting.h"

STIPPLE_PLUGIN("inpainting", "1.0") {
  registry.add(stipple::makeInpainting());
}
