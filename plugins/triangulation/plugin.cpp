#include "plugins/api/plugin.h"
#include "plugins/triangulation/triangulation.h"

STIPPLE_PLUGIN("triangulation", "1.0") {
  registry.add(stipple::makeTriangulation());
}
