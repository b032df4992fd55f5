#include "plugins/api/plugin.h"
#include "plugins/classifier/classifier.h"

STIPPLE_PLUGIN("classifier", "1.0") {
  registry.add(stipple::makeClassifier());
}
