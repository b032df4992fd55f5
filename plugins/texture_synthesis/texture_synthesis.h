#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// Patterns grown by reaction and diffusion (Section 8.2): writes `species_a`, `species_b`, ... and, on
/// request, `color`.
std::unique_ptr<Operator> makeTextureSynthesis();

}  // namespace stipple
