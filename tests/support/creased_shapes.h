#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "core/points/point_set.h"

/// Random samples of surfaces with creases, each point with the face that it lies on.
namespace stipple::shapes {

struct FacedPoints {
  std::vector<Eigen::Vector3f> positions;
  std::vector<int> faces;
};

/// A unit square folded along its middle by `turn` (radians), turned in space by the seed. `noise` is the
/// standard deviation along the normal in mean spacings.
inline FacedPoints foldedSquare(double turn, int count, std::uint64_t seed, double noise = 0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7 + static_cast<double>(seed), Eigen::Vector3d(1, 2, 0.5).normalized())
          .toRotationMatrix();
  FacedPoints points;
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random) - 0.5, y = uniform(random);
    const double angle = x < 0 ? 0 : turn;
    const Eigen::Vector3d place(x * std::cos(angle), y, -x * std::sin(angle));
    const Eigen::Vector3d n(std::sin(angle), 0, std::cos(angle));
    points.positions.push_back(
        (rotation * (place + noise / std::sqrt(count) * normal(random) * n)).cast<float>());
    points.faces.push_back(x < 0 ? 0 : 1);
  }
  return points;
}

/// Uniform random points of the surface of the cube [-1, 1]^3; faces 0 to 5.
inline FacedPoints randomCube(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::uniform_int_distribution<int> side(0, 5);
  FacedPoints points;
  for (int i = 0; i < count; ++i) {
    const int face = side(random);
    Eigen::Vector3f p(uniform(random), uniform(random), uniform(random));
    p[face / 2] = face % 2 == 0 ? -1.f : 1.f;
    points.positions.push_back(p);
    points.faces.push_back(face);
  }
  return points;
}

/// Uniform random points of the triangles of `mesh`. Faces are the parts that edges turning by less than
/// `crease` (radians) hold together, of the welded mesh.
FacedPoints sampleFaces(const PointSet& mesh, double crease, int count, std::uint64_t seed, double noise = 0);

}  // namespace stipple::shapes
