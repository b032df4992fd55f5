#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// Fairing by anisotropic geometric diffusion (Section 8.5 of the paper): writes position, normal,
/// displacement.
std::unique_ptr<Operator> makeFairing();

}  // namespace stipple
