#include "plugins/texture_synthesis/pattern_seeds.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/geometry/moments.h"
#include "core/geometry/neighborhoods.h"
#include "core/points/region.h"

namespace stipple {

namespace {

constexpr int kNeighbors = 30;
// Above this a neighborhood is flat or evenly curved: creases from about 40 degrees lie below.
constexpr float kEdge = 0.9f;

// Finalizer of the generator SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t hash(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

float quantile(std::vector<float>& values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

std::vector<float> irregularities(Index sites, std::uint64_t seed) {
  std::vector<float> values(sites);
  const std::uint64_t stream = hash(seed);
  for (Index s = 0; s < sites; ++s) {
    values[s] = static_cast<float>(hash(stream + s) >> 40) * 0x1p-23f - 1;
  }
  return values;
}

std::vector<Index> seedsAtEdges(const Sites& sites, double fraction, const Progress* progress) {
  const std::vector<float> classifier = classify(fitMoments(sites, kNeighbors, progress));
  std::vector<float> sorted = classifier;
  const float low = quantile(sorted, 0.01), high = quantile(sorted, 0.99);
  if (low > kEdge) {
    throw InvalidInput("zebra cannot start: the surface has no edges; paint seeds for it");
  }
  const float threshold = low + static_cast<float>(fraction) * (high - low);
  std::vector<Index> seeds;
  for (Index s = 0; s < sites.size(); ++s) {
    if (classifier[s] <= threshold) seeds.push_back(s);
  }
  return seeds;
}

std::vector<Index> seedsFromAttribute(const PointSet& points, const Sites& sites,
                                      const std::string& attribute) {
  const Region marked = regionWhereNotZero(points, attribute);
  std::vector<std::uint8_t> isSeed(sites.size(), 0);
  for (Index point = 0; point < points.size(); ++point) {
    if (marked.contains(point)) isSeed[sites.siteOfPoint[point]] = 1;
  }
  std::vector<Index> seeds;
  for (Index s = 0; s < sites.size(); ++s) {
    if (isSeed[s]) seeds.push_back(s);
  }
  if (seeds.empty()) throw InvalidInput("attribute \"" + attribute + "\" is 0 everywhere: it holds no seed");
  return seeds;
}

std::vector<Index> scatteredDiscs(const PatternSurface& surface, double radius, std::uint64_t seed) {
  const Sites& sites = surface.discretization.sites;
  const double discs = std::max(1.0, surface.area / (16 * radius * radius));
  const std::vector<double>& mass = surface.discretization.mass;
  const std::vector<float> chances = irregularities(sites.size(), seed);
  // At least the luckiest site.
  const auto luckiest =
      static_cast<Index>(std::min_element(chances.begin(), chances.end()) - chances.begin());
  const NeighborSearch search(sites.positions, kNeighbors);
  std::vector<std::uint8_t> isInside(sites.size(), 0);
  std::vector<Index> neighbors;
  std::vector<float> squaredDistances;
  for (Index s = 0; s < sites.size(); ++s) {
    // By area, so that sparse places get their share.
    const bool isCenter = 0.5 * (static_cast<double>(chances[s]) + 1) < discs * mass[s] / surface.area;
    if (!isCenter && s != luckiest) continue;
    isInside[s] = 1;
    search.findWithin(s, static_cast<float>(radius), neighbors, squaredDistances);
    for (const Index n : neighbors) isInside[n] = 1;
  }
  std::vector<Index> inside;
  for (Index s = 0; s < sites.size(); ++s) {
    if (isInside[s]) inside.push_back(s);
  }
  return inside;
}

}  // namespace stipple
