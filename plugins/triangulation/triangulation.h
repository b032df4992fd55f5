#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// A conforming set of triangles from the fans (Section 9 of the paper, with votes): writes the triangle
/// list.
std::unique_ptr<Operator> makeTriangulation();

}  // namespace stipple
