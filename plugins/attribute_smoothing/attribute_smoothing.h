#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// Diffusion of an attribute along the surface (Section 3 of the paper): writes the attribute.
std::unique_ptr<Operator> makeAttributeSmoothing();

}  // namespace stipple
