#include "plugins/fairing/fairing_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace stipple {

namespace {

// Neighbors of the classifier at little noise, and for noise of a spacing.
constexpr int kLeastNeighbors = 60, kMostNeighbors = 120;
// The noise is that of 16 neighbors: with more, the curvature of coarse scans counts as noise.
constexpr int kNoiseNeighbors = 16;

}  // namespace

int classifierNeighbors(double noise) {
  return std::clamp(static_cast<int>(std::lround(kMostNeighbors * std::min(noise, 1.0))), kLeastNeighbors,
                    kMostNeighbors);
}

FairingSurface::FairingSurface(const PointSet& points, const FairingOptions& options, Progress& progress) {
  PartialProgress preparing(progress, 0, 0.7);
  discretization_ = discretize(points, options.discretization, preparing);
  const Discretization& d = discretization_;
  squaredSpacing_ = std::accumulate(d.mass.begin(), d.mass.end(), 0.0) / std::max<double>(d.size(), 1);
  if (options.tensor == FairingTensor::kIsotropic) {
    stiffness_ = assembleStiffness(d, &progress);
    return;
  }
  progress.report(0.7, "looking for creases");
  noise_ = estimateNoise(d.sites, kNoiseNeighbors);
  neighbors_ = options.k > 0 ? std::max(options.k, 6) : classifierNeighbors(noise_);
  const std::vector<Moments> moments = fitMoments(d.sites, neighbors_, &progress);
  progress.report(0.9, "assembling");
  const auto tensors = fairingTensors(moments, options.tensor, classifierOfCrease(options.creaseAngle),
                                      noise_ * std::sqrt(squaredSpacing_));
  stiffness_ = assembleStiffness(d, tensors, &progress);
}

std::vector<Eigen::Vector3f> FairingSurface::normalsAt(const Eigen::MatrixXd& places,
                                                       const std::vector<Eigen::Vector3f>& along) const {
  const Fans& fans = discretization_.fans;
  std::vector<Eigen::Vector3f> normals(fans.size());
  parallelFor(fans.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const auto spokes = fans.of(i);
      const auto flags = fans.flagsOf(i);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t s = 0; s < spokes.size(); ++s) {
        if (flags[s] & Fans::kGapAfter) continue;
        const Index a = spokes[s], b = spokes[s + 1 == spokes.size() ? 0 : s + 1];
        const Eigen::Vector3d toA = places.row(a) - places.row(i), toB = places.row(b) - places.row(i);
        sum += toA.cross(toB);
      }
      Eigen::Vector3f normal = sum.stableNormalized().cast<float>();
      if (!(normal.squaredNorm() > 0.5f)) normal = discretization_.normals[i];
      normals[i] = normal.dot(along[i]) < 0 ? Eigen::Vector3f(-normal) : normal;
    }
  });
  return normals;
}

}  // namespace stipple
