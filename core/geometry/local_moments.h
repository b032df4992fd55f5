#pragma once

#include <Eigen/Core>
#include <span>

#include "core/parallel.h"

namespace stipple {

/// A site and its neighbors, as one set of points: their number, barycenter relative to the site, and
/// covariance (length^2, divided by the number).
struct LocalMoments {
  double count;
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
};

/// Summed about the site itself, where the numbers are small.
inline LocalMoments sumMoments(std::span<const Eigen::Vector3f> positions, Index site,
                               std::span<const Index> neighbors) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (const Index j : neighbors) {
    const Eigen::Vector3d d = (positions[j] - positions[site]).cast<double>();
    sum += d;
    products.noalias() += d * d.transpose();
  }
  const double count = static_cast<double>(neighbors.size()) + 1;
  const Eigen::Vector3d mean = sum / count;
  return {count, mean, products / count - mean * mean.transpose()};
}

}  // namespace stipple
