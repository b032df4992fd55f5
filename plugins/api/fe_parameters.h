#pragma once

#include <vector>

#include "core/geometry/discretization.h"
#include "plugins/api/parameter.h"

namespace stipple {

/// `own` followed by `scheme`, `metric` and `consensus`, which every finite-element operator has.
std::vector<Parameter> withFeParameters(std::vector<Parameter> own);

/// Those three as options of discretize(); the rest at its default.
DiscretizationOptions discretizationOptions(const Parameters& parameters);

}  // namespace stipple
