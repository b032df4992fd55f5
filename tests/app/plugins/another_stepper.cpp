// An operator id that another plugin has too, after one that is free.
#include "plugins/api/plugin.h"

STIPPLE_PLUGIN("another stepper", "1.0") {
  for (const char* id : {"free", "stepper"}) {
    registry.add(stipple::makeOneShot({.id = id, .title = id}, nullptr));
  }
}
