#include "plugins/api/plugin.h"
#include "plugins/segmentation/segmentation.h"

STIPPLE_PLUGIN("segmentation", "1.0") {
  registry.add(stipple::makeSegmentation());
}
