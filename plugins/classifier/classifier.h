#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// The surface classifier of Section 8.1: writes `classifier`, 1 where flat, small at creases.
std::unique_ptr<Operator> makeClassifier();

}  // namespace stipple
