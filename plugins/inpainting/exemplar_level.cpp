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
// A step away from what is known counts for this much less (Wexler et al. 2007).
constexpr float kFading = 1.3f;
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
    if (level.kinds[site] == Kind::kTarget)
      confidence[site] = std::pow(kFading, -static_cast<float>(level.hops[site]));
    if (level.kinds[site] == Kind::kOther) confidence[site] = kOtherConfidence;
  }
  return confidence;
}

// What is known from surface, kinds and features.
void addPatches(ExemplarLevel& level, const Progress* progress) {
  const Index size = level.surface.size();
  level.hops = countHops(level.surface, level.kinds);
  std::vector<std::uint8_t> isCompared(size, 0), isSource(size, 0);
  constexpr std::size_t kBlock = 512;
  parallelFor(
      size, kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (auto site = static_cast<Index>(begin); site < end; ++site) {
          const PatchStencil stencil = fitStencil(level.surface, site);
          const StencilKind kind = kindOf(stencil, level.kinds);
          isCompared[site] =
              level.kinds[site] == Kind::kTarget || (level.kinds[site] == Kind::kKnown && kind.hasTarget);
          isSource[site] = kind.isKnown && level.kinds[site] == Kind::kKnown && stencil.isWhole();
        }
      },
      progress);
  level.comparedRows.assign(size, kNoRow);
  level.sourceRows.assign(size, kNoRow);
  for (Index site = 0; site < size; ++site) {
    if (level.kinds[site] == Kind::kTarget) level.targets.push_back(site);
    if (isCompared[site]) {
      level.comparedRows[site] = static_cast<Index>(level.compared.size());
      level.compared.push_back(site);
    }
    if (isSource[site]) {
      level.sourceRows[site] = static_cast<Index>(level.sources.size());
      level.sources.push_back(site);
    }
  }

  level.sourcePatches.resize(static_cast<Eigen::Index>(level.sources.size()),
                             kSamples * level.features.cols());
  parallelFor(
      level.sources.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s)
          samplePatch(fitStencil(level.surface, level.sources[s]), level.features,
                      level.sourcePatches.row(static_cast<Eigen::Index>(s)).data());
      },
      progress);
  level.stencils.resize(level.compared.size());
  level.confidence.resize(level.compared.size());
  const std::vector<float> confidence = confidenceOfSites(level);
  parallelFor(
      level.compared.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
          level.stencils[c] = fitStencil(level.surface, level.compared[c]);
          level.confidence[c] = sampleNumber(level.stencils[c], confidence);
          const float sum = level.confidence[c].sum();
          if (sum > 0) level.confidence[c] /= sum;
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

ExemplarLevel makeFinestLevel(const Surround& surround, std::vector<Eigen::Matrix3f> frames,
                              Features features, float spacing, const Progress* progress) {
  ExemplarLevel level;
  level.surface = findTangentPlaces(surround.sites, std::move(frames), spacing, progress);
  level.kinds = surround.kinds;
  level.features = std::move(features);
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
