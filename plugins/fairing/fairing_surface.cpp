#include "plugins/fairing/fairing_surface.h"

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

}  // namespace stipple
