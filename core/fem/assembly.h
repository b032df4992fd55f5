#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>

#include "core/geometry/discretization.h"

namespace stipple {

/// Compressed rows, full symmetric pattern (both triangles stored), columns ascending.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// Mean of the diffusivities of the two ends of an edge. harmonic blocks where either is 0.
enum class EdgeMean { kArithmetic, kHarmonic };

/// Stiffness matrix L of -div(grad u) on the sites (m x m): symmetric, positive semidefinite, rows sum to 0,
/// dimensionless. Scheme voronoi: off-diagonals <= 0. (Scheme paper: not always semidefinite.)
SparseMatrix assembleStiffness(const Discretization& d, const Progress* progress = nullptr);

/// The same for -div(a grad u) with one diffusivity >= 0 a site.
SparseMatrix assembleStiffness(const Discretization& d, std::span<const double> diffusivity, EdgeMean mean,
                               const Progress* progress = nullptr);

/// The same for -div(A grad u), A symmetric positive semidefinite, 3 x 3 in world coordinates, one a site: average of
/// the elements of all fans, whatever the scheme (Eq. (8)-(10) for scheme paper).
SparseMatrix assembleStiffness(const Discretization& d, std::span<const Eigen::Matrix3d> tensor,
                               const Progress* progress = nullptr);

/// W^T L W and the mass shared out, W averaging the copies of a place: rows are those of the file (n x n).
SparseMatrix expandToPoints(const Sites& sites, const SparseMatrix& stiffness);
std::vector<double> expandMassToPoints(const Sites& sites, std::span<const double> mass);

}  // namespace stipple
