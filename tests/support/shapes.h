#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

/// Point sets with known answers.
namespace stipple::shapes {

/// Uniform random points on the unit sphere, in random order.
inline std::vector<Eigen::Vector3f> randomSphere(std::size_t count, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3f> points(count);
  for (Eigen::Vector3f& p : points) {
    const double x = normal(random), y = normal(random), z = normal(random);
    p = Eigen::Vector3d(x, y, z).normalized().cast<float>();
  }
  return points;
}

/// side x side points of the unit square, turned by a rotation.
inline std::vector<Eigen::Vector3f> grid(int side,
                                         const Eigen::Matrix3f& rotation = Eigen::Matrix3f::Identity()) {
  std::vector<Eigen::Vector3f> points;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Eigen::Vector3f p(static_cast<float>(x) / static_cast<float>(side - 1),
                              static_cast<float>(y) / static_cast<float>(side - 1), 0);
      points.push_back(rotation * p);
    }
  }
  return points;
}

/// Uniform random points of the unit square in z = 0.
inline std::vector<Eigen::Vector3f> randomSquare(std::size_t count, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> uniform;
  std::vector<Eigen::Vector3f> points(count);
  for (Eigen::Vector3f& p : points) {
    const float x = uniform(random), y = uniform(random);
    p = {x, y, 0};
  }
  return points;
}

}  // namespace stipple::shapes
