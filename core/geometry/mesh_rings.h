#pragma once

#include <span>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// Fills normals, fans, weights and mass of scheme mesh from d.meshTriangles: classical cotangent weights (Pinkall and
/// Polthier 1993; negative at obtuse pairs), a third of the triangles as mass.
void discretizeMesh(Discretization& d);

}  // namespace stipple
