#include "plugins/inpainting/exemplar_level.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/neighborhoods.h"

namespace stipple {

namespace {

using Kind = Surround::Kind;

// Points that keep this distance from each other, taken one after the other until no more fit, have a mean
// spacing 1.2 times as large.
constexpr float kDistanceInSpacings = 1 / 1.2f;
// Of the neighbors, which count as adjacent.
constexpr std::size_t kAdjacent = 8;
constexpr std::size_t kBlock = 256;
// The roughness counts for this much more than a color: found on holes in a scan of a rough skin, which kept
// four fifths of its contrast with it and three quarters without.
constexpr float kRoughnessWeight = 3;
// What other parts of the mask have may not be right yet.
constexpr float kOtherConfidence = 0.1f;

std::vector<int> countHops(const TangentPlaces& surface, std::span<const Kind> kinds) {
  constexpr int kFar = 1000;
  std::vector<int> hops(surface.size(), kFar);
  std::vector<Index> front, next;
  for (Index site = 0; site < surface.size(); ++site) {
    if (kinds[site] != Kind::kKnown) continue;
    hops[site] = 0;
    front.push_back(site);
  }
  for (int hop = 1; !front.empty(); ++hop) {
    next.clear();
    for (const Index site : front) {
      const std::span<const Index> neighbors = surface.of(site);
      for (const Index neighbor : neighbors.first(std::min(kAdjacent, neighbors.size()))) {
        if (hops[neighbor] <= hop) continue;
        hops[neighbor] = hop;
        next.push_back(neighbor);
      }
    }
    std::swap(front, next);
  }
  return hops;
}

struct StencilKind {
  bool hasTarget = false, isKnown = true;
};
StencilKind kindOf(const PatchStencil& stencil, std::span<const Kind> kinds) {
  StencilKind kind;
  for (std::size_t r = 0; r < stencil.sites.size(); ++r) {
    if (!(stencil.weights[r] > 0)) continue;
    kind.hasTarget |= kinds[stencil.sites[r]] == Kind::kTarget;
    kind.isKnown &= kinds[stencil.sites[r]] == Kind::kKnown;
  }
  return kind;
}

std::vector<float> confidenceOfSites(const ExemplarLevel& level) {
  std::vector<float> confidence(level.kinds.size(), 1);
  for (std::size_t site = 0; site < confidence.size(); ++site) {
    if (level.kinds[site] == Kind::kTarget) confidence[site] = fading(level.hops[site]);
    if (level.kinds[site] == Kind::kOther) confidence[site] = kOtherConfidence;
  }
  return confidence;
}

// The sources and their patches; which other patches hold a target.
std::vector<std::uint8_t> findSources(ExemplarLevel& level, const Progress* progress) {
  const Index size = level.surface.size();
  std::vector<std::uint8_t> hasTarget(size, 0);
  level.isSource.assign(size, 0);
  level.patches.resize(size, kSamples * level.features.cols());
  parallelFor(
      size, kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (auto site = static_cast<Index>(begin); site < end; ++site) {
          if (level.kinds[site] != Kind::kKnown) continue;
          const PatchStencil stencil = fitStencil(level.surface, site);
          const StencilKind kind = kindOf(stencil, level.kinds);
          hasTarget[site] = kind.hasTarget;
          if (!kind.isKnown || !stencil.isWhole()) continue;
          level.isSource[site] = 1;
          samplePatch(stencil, level.features, level.patches.row(site).data());
        }
      },
      progress);
  return hasTarget;
}

// All that follows from surface, kinds and features.
void addPatches(ExemplarLevel& level, const Progress* progress) {
  const Index size = level.surface.size();
  level.hops = countHops(level.surface, level.kinds);
  const std::vector<std::uint8_t> hasTarget = findSources(level, progress);
  level.comparedRows.assign(size, kNoRow);
  for (Index site = 0; site < size; ++site) {
    const bool isTarget = level.kinds[site] == Kind::kTarget;
    if (level.isSource[site]) level.sources.push_back(site);
    if (isTarget) level.targets.push_back(site);
    if (!isTarget && !hasTarget[site]) continue;
    level.comparedRows[site] = static_cast<Index>(level.compared.size());
    level.compared.push_back(site);
  }
  level.stencils.resize(level.compared.size());
  level.confidence.resize(level.compared.size());
  const std::vector<float> confidence = confidenceOfSites(level);
  parallelFor(
      level.compared.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
          level.stencils[c] = fitStencil(level.surface, level.compared[c]);
          level.confidence[c] = normalized(sampleNumber(level.stencils[c], confidence));
        }
      },
      progress);
}

// Sites of the level that keep their distance, in order.
std::vector<Index> chooseThinned(const ExemplarLevel& fine, const NeighborSearch& search, float distance) {
  std::vector<std::uint8_t> isCovered(fine.surface.size(), 0);
  std::vector<Index> chosen, neighbors;
  std::vector<float> squared;
  for (Index site = 0; site < fine.surface.size(); ++site) {
    if (isCovered[site]) continue;
    chosen.push_back(site);
    search.findWithin(site, distance, neighbors, squared);
    for (const Index neighbor : neighbors) isCovered[neighbor] = 1;
  }
  return chosen;
}

// Gaussian mean of what is within the distance, on the same side of the surface; where known, of known ones.
Eigen::RowVectorXf meanAround(const ExemplarLevel& fine, const NeighborSearch& search, Index site,
                              float distance) {
  std::vector<Index> neighbors;
  std::vector<float> squared;
  search.findWithin(site, distance, neighbors, squared);
  Eigen::RowVectorXf sum = fine.features.row(site);
  float weights = 1;
  for (std::size_t n = 0; n < neighbors.size(); ++n) {
    const Index neighbor = neighbors[n];
    if (fine.kinds[site] == Kind::kKnown && fine.kinds[neighbor] != Kind::kKnown) continue;
    if (fine.surface.frames[site].col(2).dot(fine.surface.frames[neighbor].col(2)) < 0) continue;
    const float weight = std::exp(-2 * squared[n] / (distance * distance));
    sum += weight * fine.features.row(neighbor);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

// One more channel: how much values differ from those around them (root mean square), smoothed. It tells a
// rough texture from a smooth fill of its mean (Newson et al. 2014). Where it is not known it is the mean of
// the rest.
void addRoughness(ExemplarLevel& level, const Progress* progress) {
  const TangentPlaces& surface = level.surface;
  const Eigen::Index channels = level.features.cols();
  const auto isKnown = [&](Index site) { return level.kinds[site] == Kind::kKnown; };
  Eigen::VectorXf squares = Eigen::VectorXf::Zero(surface.size()), rough = squares;
  const auto overSites = [&](const auto& body) {
    parallelFor(
        surface.size(), 2048,
        [&](std::size_t begin, std::size_t end) {
          for (auto site = static_cast<Index>(begin); site < end; ++site) {
            if (isKnown(site)) body(site);
          }
        },
        progress);
  };
  overSites([&](Index site) {
    const std::span<const Index> near = surface.of(site);
    float count = 0;
    for (const Index neighbor : near.first(std::min(kAdjacent, near.size()))) {
      if (!isKnown(neighbor)) continue;
      squares[site] += (level.features.row(neighbor) - level.features.row(site)).squaredNorm();
      ++count;
    }
    squares[site] /= std::max(count, 1.f);
  });
  overSites([&](Index site) {
    float sum = squares[site], count = 1;
    for (const Index neighbor : surface.of(site)) {
      if (!isKnown(neighbor)) continue;
      sum += squares[neighbor];
      ++count;
    }
    rough[site] = std::sqrt(sum / count);
  });
  const auto known = static_cast<float>(std::ranges::count(level.kinds, Kind::kKnown));
  const float mean = rough.sum() / std::max(known, 1.f);
  Features extended(surface.size(), channels + 1);
  extended.leftCols(channels) = level.features;
  for (Index site = 0; site < surface.size(); ++site)
    extended(site, channels) = kRoughnessWeight * (isKnown(site) ? rough[site] : mean);
  level.features = std::move(extended);
}

ExemplarLevel makeFinestLevel(const Surround& surround, std::vector<Eigen::Matrix3f> frames,
                              Features features, float spacing, const Progress* progress) {
  ExemplarLevel level;
  level.surface = findTangentPlaces(surround.sites, std::move(frames), spacing, progress);
  level.kinds = surround.kinds;
  level.features = std::move(features);
  addRoughness(level, progress);
  addPatches(level, progress);
  return level;
}

ExemplarLevel thinLevel(const ExemplarLevel& fine, const Progress* progress) {
  const float spacing = 2 * fine.surface.spacing, distance = kDistanceInSpacings * spacing;
  const NeighborSearch search(fine.surface.positions, 12);
  const std::vector<Index> chosen = chooseThinned(fine, search, distance);
  std::vector<Eigen::Vector3f> positions;
  for (const Index site : chosen) positions.push_back(fine.surface.positions[site]);
  const Sites sites = weldAndOrder(positions);

  ExemplarLevel level;
  level.features.resize(sites.size(), fine.features.cols());
  std::vector<Eigen::Matrix3f> frames(sites.size());
  for (Index site = 0; site < sites.size(); ++site) {
    const Index from = chosen[sites.pointOfSite[site]];
    level.finer.push_back(from);
    level.kinds.push_back(fine.kinds[from]);
    frames[site] = fine.surface.frames[from];
    level.features.row(site) = meanAround(fine, search, from, distance);
  }
  level.surface = findTangentPlaces(sites, std::move(frames), spacing, progress);
  addPatches(level, progress);
  return level;
}

}  // namespace stipple
