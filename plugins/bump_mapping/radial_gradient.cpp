#include "plugins/bump_mapping/radial_gradient.h"

#include "core/geometry/neighborhoods.h"

namespace stipple {

namespace {

// Of more points within the radius every r-th is taken.
constexpr int kCap = 200;

double weight(double r) {
  return r < 1 ? (2 * r - 3) * r * r + 1 : 0;
}

double slope(double r) {
  return r < 1 ? 6 * r * (r - 1) : 0;
}

}  // namespace

std::vector<Eigen::Vector3d> radialGradient(const Discretization& d, std::span<const double> values,
                                            double radius, const Progress* progress) {
  const Neighborhoods near =
      findNeighborhoods(d.sites, {.k = 8, .epsilon = static_cast<float>(radius), .cap = kCap}, progress);
  std::vector<Eigen::Vector3d> gradients(d.size(), Eigen::Vector3d::Zero());
  parallelFor(
      d.size(), 4096,
      [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
          double weights = 1, weighted = values[i];  // of the site itself
          Eigen::Vector3d slopes = Eigen::Vector3d::Zero(), weightedSlopes = Eigen::Vector3d::Zero();
          for (const Index j : near.of(i)) {
            const Eigen::Vector3d away = (d.sites.positions[i] - d.sites.positions[j]).cast<double>();
            const double distance = away.norm(), r = distance / radius;
            if (!(distance > 0) || r >= 1) continue;
            const Eigen::Vector3d change = slope(r) / (radius * distance) * away;
            weights += weight(r);
            weighted += weight(r) * values[j];
            slopes += change;
            weightedSlopes += values[j] * change;
          }
          const Eigen::Vector3d gradient = (weightedSlopes - weighted / weights * slopes) / weights;
          const Eigen::Vector3d n = d.normals[i].cast<double>();
          gradients[i] = gradient - n * n.dot(gradient) / n.squaredNorm();
        }
      },
      progress);
  return gradients;
}

}  // namespace stipple
