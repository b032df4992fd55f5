#include "plugins/api/plugin.h"
#include "plugins/fairing/fairing.h"

STIPPLE_PLUGIN("fairing", "1.0") {
  registry.add(stipple::makeFairing());
}
