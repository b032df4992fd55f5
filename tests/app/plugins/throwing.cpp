// Throws after its first operator was added.
#include <stdexcept>

#include "plugins/api/plugin.h"

STIPPLE_PLUGIN("throwing", "1.0") {
  registry.add(stipple::makeOneShot({.id = "half_done", .title = "Half done"}, nullptr));
  throw std::runtime_error("no license for Tuesdays");
}
