#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>

#include "core/fem/assembly.h"

namespace stipple {

/// Relative L2 errors of (M + L) u = M f on the unit sphere for f = Y_10, Y_32, Y_40, whose solution is
/// f / (1 + l (l + 1)). Solved by Eigen's factorization, not by ours.
inline std::array<double, 3> harmonicErrors(const Discretization& d) {
  Eigen::SparseMatrix<double> system = assembleStiffness(d);
  const Eigen::Map<const Eigen::VectorXd> mass(d.mass.data(), static_cast<Eigen::Index>(d.mass.size()));
  system.diagonal() += mass;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(system);
  const auto harmonic = [](std::size_t which, const Eigen::Vector3d& p) {
    const double z2 = p.z() * p.z();
    if (which == 0) return p.z();
    if (which == 1) return (p.x() * p.x() - p.y() * p.y()) * p.z();
    return 35 * z2 * z2 - 30 * z2 + 3;
  };
  const std::array<int, 3> degrees{1, 3, 4};
  std::array<double, 3> errors{};
  for (std::size_t which = 0; which < 3; ++which) {
    Eigen::VectorXd f(d.size());
    for (Index i = 0; i < d.size(); ++i) f[i] = harmonic(which, d.sites.positions[i].cast<double>());
    const Eigen::VectorXd exact = f / (1 + degrees[which] * (degrees[which] + 1));
    const Eigen::VectorXd error = factor.solve(mass.cwiseProduct(f)) - exact;
    errors[which] = std::sqrt(mass.dot(error.cwiseAbs2()) / mass.dot(exact.cwiseAbs2()));
  }
  return errors;
}

}  // namespace stipple
