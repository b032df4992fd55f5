#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/fem/assembly.h"

/// Graph Laplacian of a width x height grid with unit weights: row = y * width + x, rows sum to 0. Its
/// eigenvectors are products of cosines (discrete cosine transform).
inline stipple::SparseMatrix gridLaplacian(int width, int height) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int a, int b) {
    entries.insert(entries.end(), {{a, b, -1.0}, {b, a, -1.0}, {a, a, 1.0}, {b, b, 1.0}});
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) couple(y * width + x, y * width + x + 1);
      if (y + 1 < height) couple(y * width + x, (y + 1) * width + x);
    }
  }
  stipple::SparseMatrix laplacian(width * height, width * height);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

inline Eigen::VectorXd gridEigenvector(int width, int height, int kx, int ky) {
  Eigen::VectorXd u(width * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      u[y * width + x] = std::cos(std::numbers::pi * kx * (x + 0.5) / width) *
                         std::cos(std::numbers::pi * ky * (y + 0.5) / height);
    }
  }
  return u;
}

inline double gridEigenvalue(int width, int height, int kx, int ky) {
  return 4 - 2 * std::cos(std::numbers::pi * kx / width) - 2 * std::cos(std::numbers::pi * ky / height);
}

/// The same plus the identity times `shift`: positive definite.
inline stipple::SparseMatrix shiftedGridLaplacian(int width, int height, double shift) {
  stipple::SparseMatrix matrix = gridLaplacian(width, height);
  for (int i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) += shift;
  return matrix;
}
