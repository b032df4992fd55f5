#pragma once

#include <functional>

#include "core/fem/assembly.h"
#include "plugins/segmentation/surface_graph.h"

namespace stipple {

/// An edge with less than this weight (dimensionless) holds no pieces together: what passes a bottleneck of
/// such edges depends on digits of the weights.
inline constexpr double kLeastWeight = 0.02;

/// Stiffness of scheme mesh between the walls of the points (m x m, semidefinite). `mesh` and `points`
/// discretize the same sites; `graph` holds the edges of the fans of `points`, `isBlocked` decides for edges
/// that only the mesh has. Faces without a blocked edge keep their cotangents; of the others' sums, those
/// below 0 are dropped. Where fans join two sites and no face does, as at points on no face, the edge of the
/// fans is added.
SparseMatrix assembleMeshStiffness(const Discretization& mesh, const Discretization& points,
                                   const SurfaceGraph& graph,
                                   const std::function<bool(Index, Index)>& isBlocked,
                                   const Progress* progress);

}  // namespace stipple
