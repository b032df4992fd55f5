#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>

#include "core/fem/laplacian_builder.h"
#include "core/geometry/discretization.h"

namespace stipple {

/// Mean of the diffusivities of the two ends of an edge: arithmetic is each fan with that of its own site
/// (the paper); harmonic blocks where either is 0.
enum class EdgeMean { kArithmetic, kHarmonic };

/// Stiffness matrix L of -div(grad u) on the sites (m x m): symmetric, positive semidefinite, rows sum to 0,
/// dimensionless; off-diagonals <= 0 for scheme voronoi. (Schemes paper and mesh: positive off-diagonals
/// occur, and paper is not always semidefinite.) Scheme element averages the elements of all fans.
SparseMatrix assembleStiffness(const Discretization& d, const Progress* progress = nullptr);

/// The same for -div(a grad u) with one diffusivity >= 0 a site.
SparseMatrix assembleStiffness(const Discretization& d, std::span<const double> diffusivity, EdgeMean mean,
                               const Progress* progress = nullptr);

/// The same with each edge's weight times factor(i, j) >= 0, symmetric in i and j. Always by edges, whatever
/// the scheme.
SparseMatrix assembleStiffness(const Discretization& d, const std::function<double(Index i, Index j)>& factor,
                               const Progress* progress = nullptr);

/// The same for -div(A grad u), A symmetric positive semidefinite, 3 x 3 in world coordinates, one a site:
/// average of the elements of all fans, whatever the scheme (Eq. (8)-(10) for scheme paper).
SparseMatrix assembleStiffness(const Discretization& d, std::span<const Eigen::Matrix3d> tensor,
                               const Progress* progress = nullptr);

}  // namespace stipple
