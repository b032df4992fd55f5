#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// Segmentation by diffusion from seeds that stops at creases (Section 8.1): writes `segment` and
/// `segment_signal`.
std::unique_ptr<Operator> makeSegmentation();

}  // namespace stipple
