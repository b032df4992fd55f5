#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// Fills an attribute inside a mask from its rim (Section 8.4): writes the attribute, there only.
std::unique_ptr<Operator> makeInpainting();

}  // namespace stipple
