// Needs a function that no library has.
#include "plugins/api/plugin.h"

namespace stipple {
void functionThatNoLibraryHas();
}

STIPPLE_PLUGIN("undefined symbol", "1.0") {
  registry.add(stipple::makeOneShot({.id = "undefined", .title = "Undefined"}, nullptr));
  stipple::functionThatNoLibraryHas();
}
