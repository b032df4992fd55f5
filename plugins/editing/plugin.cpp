#include "plugins/api/plugin.h"
#include "plugins/editing/editing.h"

STIPPLE_PLUGIN("editing", "1.0") {
  registry.add(stipple::makeDeletePoints());
  registry.add(stipple::makeCrop());
  registry.add(stipple::makeRemoveOutliers());
  registry.add(stipple::makeResample());
  registry.add(stipple::makeEstimateNormals());
  registry.add(stipple::makeFlipNormals());
  registry.add(stipple::makeTransferAttributes());
}
