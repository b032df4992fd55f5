#include "plugins/fairing/fairing_tensor.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace stipple {

namespace {

// classify() without what the noise adds: its variance to the least moment, and up to twice its deviation to
// the distance from the barycenter.
std::vector<float> classifyNoisy(const std::vector<Moments>& moments, double noise) {
  std::vector<Moments> clear = moments;
  for (Moments& m : clear) {
    const double offset = m.centerOffset.norm(), left = offset * offset - 4 * noise * noise;
    if (offset > 0) m.centerOffset *= static_cast<float>(std::sqrt(std::max(0.0, left)) / offset);
    m.eigenvalues[2] = static_cast<float>(std::max(0.0, m.eigenvalues[2] - noise * noise));
  }
  return classify(clear);
}

}  // namespace

double classifierOfCrease(double angle) {
  return 1 / (1 + 141 * std::pow(std::sin(angle / 2), 6));
}

std::vector<Eigen::Matrix3d> fairingTensors(const std::vector<Moments>& moments, FairingTensor tensor,
                                            double gamma, double noise) {
  constexpr std::size_t kGrain = 4096;
  const std::vector<float> classifier =
      tensor == FairingTensor::kFeatures ? classifyNoisy(moments, noise) : classify(moments);
  std::vector<Eigen::Matrix3d> tensors(moments.size(), Eigen::Matrix3d::Identity());
  if (tensor == FairingTensor::kIsotropic) return tensors;
  parallelFor(moments.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Moments& m = moments[i];
      const double c = classifier[i];
      double along = 1, across = c;
      if (tensor == FairingTensor::kFeatures) {
        across = c > gamma ? std::sqrt((c - gamma) / (1 - gamma)) : 0;
        const double largest = m.eigenvalues[0];
        const double elongation = largest > 0 ? 2 * (largest - m.eigenvalues[1]) / largest : 0;
        along = std::max(across, std::min(1.0, elongation));
      }
      const Eigen::Vector3d w = m.axes.col(0).cast<double>();
      tensors[i] = across * Eigen::Matrix3d::Identity() + (along - across) * w * w.transpose();
    }
  });
  return tensors;
}

}  // namespace stipple
