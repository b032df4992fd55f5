#include "plugins/fairing/resampling.h"

#include <algorithm>

namespace stipple {

namespace {

constexpr double kShrunk = 0.8, kStretched = 1.3;

double distance(const Discretization& d, Index a, Index b) {
  return (d.sites.positions[a] - d.sites.positions[b]).cast<double>().norm();
}

}  // namespace

std::vector<double> localSpacings(const Discretization& d) {
  std::vector<double> spacings(d.size(), 0);
  for (Index i = 0; i < d.size(); ++i) {
    const auto spokes = d.fans.of(i);
    for (const Index j : spokes) spacings[i] += distance(d, i, j) / static_cast<double>(spokes.size());
  }
  return spacings;
}

Resampling planResampling(const Discretization& d, std::span<const double> rest) {
  const std::vector<double> spacings = localSpacings(d);
  Resampling plan;
  std::vector<std::uint8_t> isTaken(d.size(), 0);
  const auto take = [&](Index site) {
    isTaken[site] = 1;
    for (const Index j : d.fans.of(site)) isTaken[j] = 1;
  };
  for (Index i = 0; i < d.size(); ++i) {
    const auto spokes = d.fans.of(i);
    if (isTaken[i] || !(rest[i] > 0) || spokes.empty() || d.fans.open[i]) continue;
    if (spacings[i] < kShrunk * rest[i]) {
      plan.removed.push_back(i);
      take(i);
    } else if (spacings[i] > kStretched * rest[i]) {
      const Index farthest =
          *std::ranges::max_element(spokes, {}, [&](Index j) { return distance(d, i, j); });
      if (isTaken[farthest] || !(rest[farthest] > 0)) continue;
      plan.inserted.push_back({i, farthest});
      take(i);
      take(farthest);
    }
  }
  return plan;
}

}  // namespace stipple
