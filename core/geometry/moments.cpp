#include "core/geometry/moments.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/geometry/local_moments.h"

namespace stipple {

namespace {

Moments fitOne(const Sites& sites, Index site, std::span<const Index> neighbors,
               std::span<const float> squared) {
  const LocalMoments local = sumMoments(sites.positions, site, neighbors);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(local.covariance);

  Moments m;
  m.centerOffset = local.mean.cast<float>();
  m.radius = squared.empty() ? 0.f : std::sqrt(squared.back());
  m.eigenvalues = solver.eigenvalues().reverse().cwiseMax(0.0).cast<float>();
  m.axes.col(0) = solver.eigenvectors().col(2).cast<float>();
  m.axes.col(2) = solver.eigenvectors().col(0).cast<float>();
  m.axes.col(1) = m.axes.col(2).cross(m.axes.col(0));
  return m;
}

}  // namespace

std::vector<Moments> fitMoments(const Sites& sites, const Neighborhoods& neighborhoods,
                                const Progress* progress) {
  std::vector<Moments> moments(sites.size());
  parallelFor(
      sites.size(), 2048,
      [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
          moments[i] = fitOne(sites, i, neighborhoods.of(i), neighborhoods.squaredDistancesOf(i));
        }
      },
      progress);
  return moments;
}

std::vector<Moments> fitMoments(const Sites& sites, int k, const Progress* progress) {
  if (k < 1) throw InvalidInput(fmt::format("k is {}, expected at least 1", k));
  requireUsableScale(sites);
  std::vector<Moments> moments(sites.size());
  forNeighborhoods(sites, NeighborSearch(sites.positions, k), k, progress,
                   [&](Index site, std::span<const Index> neighbors, std::span<const float> squared) {
                     moments[site] = fitOne(sites, site, neighbors, squared);
                   });
  return moments;
}

std::vector<float> classify(const std::vector<Moments>& moments) {
  // G of Eq. (12) with alpha = .01, beta = 1, scaled by alpha so that flat places have C = 1.
  constexpr float kBetaOverAlphaSquared = 1e4f;
  std::vector<float> classifier(moments.size(), 1.f);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Moments& m = moments[i];
    if (!(m.radius > 0) || !(m.eigenvalues[0] > 0)) continue;
    const float s = m.centerOffset.norm() / m.radius * (m.eigenvalues[2] / m.eigenvalues[0]);
    classifier[i] = 1.f / (1.f + kBetaOverAlphaSquared * s * s);
  }
  return classifier;
}

}  // namespace stipple
