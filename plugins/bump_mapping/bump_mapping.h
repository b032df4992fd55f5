#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// Normals tilted by the gradient of a number (Section 8.3, Eq. (14)): writes `display_normal`, and `normal`
/// on request.
std::unique_ptr<Operator> makeBumpMapping();

}  // namespace stipple
