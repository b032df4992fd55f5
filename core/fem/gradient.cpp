#include "core/fem/gradient.h"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>

namespace stipple {

namespace {

struct WeightedGradient {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double angle = 0;
};

// Adds the triangle that the site makes with a and b: its gradient g is the vector in its plane with
// g . a = rise at a, g . b = rise at b.
void addTriangle(const Discretization& d, std::span<const double> values, Index site, Index a, Index b,
                 WeightedGradient& mean) {
  const Eigen::Vector3d toA = (d.sites.positions[a] - d.sites.positions[site]).cast<double>();
  const Eigen::Vector3d toB = (d.sites.positions[b] - d.sites.positions[site]).cast<double>();
  const double aa = toA.squaredNorm(), bb = toB.squaredNorm(), ab = toA.dot(toB);
  const double twiceArea = toA.cross(toB).norm();
  if (!(twiceArea > 0)) return;
  const double riseA = values[a] - values[site], riseB = values[b] - values[site];
  const double angle = std::atan2(twiceArea, ab);
  const double alongA = riseA * bb - riseB * ab, alongB = riseB * aa - riseA * ab;
  mean.sum += angle / (twiceArea * twiceArea) * (alongA * toA + alongB * toB);
  mean.angle += angle;
}

Eigen::Vector3d tangentialMean(const WeightedGradient& mean, const Eigen::Vector3f& normal) {
  if (!(mean.angle > 0)) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d gradient = mean.sum / mean.angle, n = normal.cast<double>();
  return gradient - n * n.dot(gradient) / n.squaredNorm();
}

std::vector<WeightedGradient> sumOverMesh(const Discretization& d, std::span<const double> values) {
  std::vector<WeightedGradient> means(d.size());
  for (const Triangle& t : d.meshTriangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      addTriangle(d, values, t[c], t[(c + 1) % 3], t[(c + 2) % 3], means[t[c]]);
    }
  }
  return means;
}

WeightedGradient sumOverFan(const Discretization& d, std::span<const double> values, Index site) {
  WeightedGradient mean;
  const auto spokes = d.fans.of(site);
  const auto flags = d.fans.flagsOf(site);
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    if (flags[s] & Fans::kGapAfter) continue;
    addTriangle(d, values, site, spokes[s], spokes[s + 1 == spokes.size() ? 0 : s + 1], mean);
  }
  return mean;
}

}  // namespace

std::vector<Eigen::Vector3d> fanGradient(const Discretization& d, std::span<const double> values,
                                         const Progress* progress) {
  assert(values.size() == d.size());
  const bool ofMesh = d.options.scheme == Scheme::kMesh;
  const std::vector<WeightedGradient> meshMeans =
      ofMesh ? sumOverMesh(d, values) : std::vector<WeightedGradient>{};
  std::vector<Eigen::Vector3d> gradients(d.size());
  parallelFor(
      d.size(), 4096,
      [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
          gradients[i] = tangentialMean(ofMesh ? meshMeans[i] : sumOverFan(d, values, i), d.normals[i]);
        }
      },
      progress);
  return gradients;
}

}  // namespace stipple
