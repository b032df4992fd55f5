#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/appearance/surface_mesh.h"

/// Triangles with normals and colors.
namespace stipple::scenes {

struct Mesh {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Rgba8> colors;
  std::vector<Triangle> triangles;

  SurfaceMesh view() const { return {positions, normals, colors, triangles}; }
};

/// (columns + 1) x (rows + 1) points of a surface over [0, 1]^2; `at(u, v)` gives position and normal.
template <class Surface>
Mesh meshOf(Index columns, Index rows, const Rgba8& color, const Surface& at) {
  Mesh mesh;
  for (Index row = 0; row <= rows; ++row) {
    for (Index column = 0; column <= columns; ++column) {
      const auto [position, normal] = at(static_cast<float>(column) / static_cast<float>(columns),
                                         static_cast<float>(row) / static_cast<float>(rows));
      mesh.positions.push_back(position);
      mesh.normals.push_back(normal);
      mesh.colors.push_back(color);
    }
  }
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < columns; ++column) {
      const Index a = row * (columns + 1) + column, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

/// The unit sphere by longitude and latitude.
inline Mesh sphereMesh(Index columns, Index rows, const Rgba8& color) {
  return meshOf(columns, rows, color, [](float u, float v) {
    const float turn = 2 * std::numbers::pi_v<float> * u, height = std::numbers::pi_v<float> * v;
    const Eigen::Vector3f p(std::sin(height) * std::cos(turn), std::sin(height) * std::sin(turn),
                            std::cos(height));
    return std::pair(p, p);
  });
}

/// The square [-half, half]^2 in z = 0, one pair of triangles.
inline Mesh squareMesh(float half, const Rgba8& color) {
  return meshOf(1, 1, color, [half](float u, float v) {
    return std::pair(Eigen::Vector3f(half * (2 * u - 1), half * (2 * v - 1), 0), Eigen::Vector3f(0, 0, 1));
  });
}

}  // namespace stipple::scenes
