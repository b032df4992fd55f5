#include "render/hierarchy/splat_radii.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/geometry/fans.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 4096;
// Discs that just cover leave seams where they blend.
constexpr float kCoverOverlap = 1.25f;
// Over the root of the area: enough for cells that are nearly round.
constexpr float kAreaOverlap = 1.05f;
// A disc is no larger than this many times the median distance of its neighbors to their second nearest:
// random points need twice the mean distance, rings of a lidar far apart are shown as rings.
constexpr float kMostOfSpacing = 8;
// At rims and gaps, where a fan is open, just enough to reach its neighbors.
constexpr float kMostAtRim = 6;
// And no disc is larger than this many times the disc that nine of ten do not exceed: single points far out.
constexpr float kMostOfLarge = 4, kMostOfLargeAtRim = 1.5f;
// Ratio of heights over widths of a fan from which it is no surface any more: discs shrink, up to dots for
// single points above one.
constexpr float kSteep = 0.9f, kScattered = 1.4f;
// From this ratio on a fan lies across a crease.
constexpr float kCreased = 0.6f;
constexpr float kPlausible = 8;
// Discs of a file just cover; ours also blend, and hide less than they blend.
constexpr float kGivenOverlap = 1.2f;

struct SiteEstimate {
  float cover = 0;  // distance to the farthest corner of the Voronoi cell
  float nearest = std::numeric_limits<float>::max(),
        second = nearest;  // distances to the two nearest neighbors
  float area = 0;
};

float circumradius(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float twiceArea) {
  return a.norm() * b.norm() * (a - b).norm() / (2 * twiceArea);
}

// Root of the mean square of heights above the tangent plane over that of distances in it.
float steepness(const Sites& sites, const Fans& fans, Index site, const Eigen::Vector3f& normal) {
  float heights = 0, widths = 0;
  for (const Index j : fans.of(site)) {
    const Eigen::Vector3f spoke = sites.positions[j] - sites.positions[site];
    const float height = spoke.dot(normal);
    heights += height * height;
    widths += std::max(spoke.squaredNorm() - height * height, 0.f);
  }
  return heights > 0 ? std::sqrt(heights / std::max(widths, 1e-12f * heights)) : 0;
}

SiteEstimate measureFan(const Sites& sites, const FanSet& set, Index site) {
  const std::span<const Index> spokes = set.fans.of(site);
  const std::span<const std::uint8_t> flags = set.fans.flagsOf(site);
  const Eigen::Vector3f& x = sites.positions[site];
  SiteEstimate estimate;
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    const Eigen::Vector3f a = sites.positions[spokes[s]] - x;
    const float length = a.norm();
    estimate.second = std::min(estimate.second, std::max(length, estimate.nearest));
    estimate.nearest = std::min(estimate.nearest, length);
    if (flags[s] & Fans::kGapAfter) continue;
    const Eigen::Vector3f b = sites.positions[spokes[(s + 1) % spokes.size()]] - x;
    const float twiceArea = a.cross(b).norm(), longest = std::max(a.norm(), b.norm());
    if (!(twiceArea > 1e-6f * longest * longest)) continue;
    estimate.cover = std::max(estimate.cover, std::min(circumradius(a, b, twiceArea), longest));
    estimate.area += twiceArea / 6;
  }
  if (spokes.empty()) return {};
  const float dot = 0.5f * estimate.nearest;
  const float steep = steepness(sites, set.fans, site, set.normals[site]);
  // Discs of different slopes part where they are seen at a grazing angle. At creases larger ones would stand
  // out.
  estimate.cover *= 1 + std::max(0.f, std::min(steep, kCreased - steep));
  const float share = std::clamp((kScattered - steep) / (kScattered - kSteep), 0.f, 1.f);
  estimate.cover = std::max(dot + share * (estimate.cover - dot), std::min(dot, estimate.cover));
  if (!(estimate.cover > 0)) estimate.cover = dot;
  return estimate;
}

std::vector<SiteEstimate> measureFans(const Sites& sites, const FanSet& set, const Progress* progress) {
  std::vector<SiteEstimate> estimates(sites.size());
  parallelFor(
      sites.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (auto site = static_cast<Index>(begin); site < end; ++site)
          estimates[site] = measureFan(sites, set, site);
      },
      progress);
  return estimates;
}

template <class T>
T medianOf(std::vector<T>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Discs of outliers and of points at wide gaps shrink to a few times the spacing of what stands around them.
std::vector<float> limitBySpacing(const Fans& fans, const std::vector<SiteEstimate>& estimates,
                                  const Progress* progress) {
  std::vector<float> covers(estimates.size());
  parallelFor(
      estimates.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        std::vector<float> around;
        for (auto site = static_cast<Index>(begin); site < end; ++site) {
          around.assign(1, estimates[site].second);
          for (const Index j : fans.of(site)) around.push_back(estimates[j].second);
          covers[site] = std::min(estimates[site].cover,
                                  (fans.open[site] ? kMostAtRim : kMostOfSpacing) * medianOf(around));
        }
      },
      progress);
  std::vector<float> sorted = covers;
  if (sorted.empty()) return covers;
  const auto large = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
  std::nth_element(sorted.begin(), large, sorted.end());
  const float most = *large;
  for (Index site = 0; site < covers.size(); ++site)
    covers[site] = std::min(covers[site], most * (fans.open[site] ? kMostOfLargeAtRim : kMostOfLarge));
  return covers;
}

// What no neighbor tells (single points, copies of one place): the median of the others, or a hundredth of
// the extent.
float fallbackRadius(const Sites& sites, const std::vector<float>& covers) {
  std::vector<float> known;
  for (const float cover : covers) {
    if (cover > 0) known.push_back(cover);
  }
  if (!known.empty()) return medianOf(known);
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : sites.positions) box.extend(p);
  const float extent = box.isEmpty() ? 0 : box.diagonal().norm();
  return extent > 0 ? 0.01f * extent : 1;
}

std::vector<float> radiiOfFile(const PointSet& points, const std::vector<float>& estimated) {
  const Attribute* attribute = points.find("radius");
  if (!attribute || attribute->type() != AttributeType::kFloat || estimated.empty()) return {};
  const std::span<const float> given = points.values<float>("radius");
  std::vector<float> ratios;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!(given[i] > 0) || !std::isfinite(given[i])) return {};
    ratios.push_back(given[i] / estimated[i]);
  }
  const float ratio = medianOf(ratios);
  if (ratio > kPlausible || ratio < 1 / kPlausible) return {};
  std::vector<float> radii(given.begin(), given.end());
  for (float& radius : radii) radius *= kGivenOverlap;
  return radii;
}

}  // namespace

namespace {

// Mean of the normals of the triangles about a point, weighted by their areas; 0 for points of no triangle.
std::vector<Eigen::Vector3f> normalsOfTriangles(const PointSet& points) {
  if (points.triangles().empty()) return {};
  const auto positions = points.positions();
  std::vector<Eigen::Vector3f> normals(points.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : points.triangles()) {
    const Eigen::Vector3f normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    for (const Index corner : {a, b, c}) normals[corner] += normal;
  }
  for (Eigen::Vector3f& normal : normals) {
    normal.stableNormalize();
    if (!normal.allFinite()) normal.setZero();
  }
  return normals;
}

}  // namespace

namespace {

// Vectors of length 1, or 0 where they have no direction. Empty where none has.
std::vector<Eigen::Vector3f> directionsOf(std::span<const Eigen::Vector3f> given) {
  constexpr std::size_t kGrain = 1 << 15;
  std::vector<Eigen::Vector3f> directions(given.size());
  std::atomic<bool> any = false;
  parallelFor(given.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    bool anyHere = false;
    for (std::size_t i = begin; i < end; ++i) {
      // Squares of what is far from 1 leave the range of floats.
      const float squared = given[i].squaredNorm();
      const bool isPlain = squared > 1e-20f && squared < 1e20f;
      const float length = isPlain ? std::sqrt(squared) : given[i].stableNorm();
      const bool isDirection = length > 0 && std::isfinite(length);
      directions[i] = isDirection ? Eigen::Vector3f(given[i] / length) : Eigen::Vector3f::Zero();
      anyHere = anyHere || isDirection;
    }
    if (anyHere) any = true;
  });
  if (!any) directions.clear();
  return directions;
}

}  // namespace

std::vector<Eigen::Vector3f> normalsOfFile(const PointSet& points) {
  for (const char* name : {"display_normal", "normal"}) {
    const Attribute* attribute = points.find(name);
    if (!attribute || attribute->type() != AttributeType::kVector3) continue;
    std::vector<Eigen::Vector3f> normals = directionsOf(points.values<Eigen::Vector3f>(name));
    if (!normals.empty()) return normals;
  }
  return normalsOfTriangles(points);
}

SurfaceEstimate estimateSurface(const PointSet& points, const Progress* progress) {
  const Sites sites = weldAndOrder(points.positions());
  const FanSet set = buildFans(sites, {}, progress);
  const std::vector<SiteEstimate> estimates = measureFans(sites, set, progress);
  const std::vector<float> covers = limitBySpacing(set.fans, estimates, progress);
  const float fallback = fallbackRadius(sites, covers);

  SurfaceEstimate surface{std::vector<float>(points.size()), std::vector<float>(points.size()),
                          normalsOfFile(points)};
  const bool hasNormals = !surface.normals.empty();
  if (!hasNormals) surface.normals.assign(points.size(), Eigen::Vector3f::Zero());
  for (Index point = 0; point < points.size(); ++point) {
    const Index site = sites.siteOfPoint[point];
    const float cover = covers[site] > 0 ? covers[site] : fallback;
    // A fan that was cut down, or has hardly a triangle, stands for a disc's share at least.
    const float area = std::clamp(estimates[site].area, 0.3f * cover * cover, 3 * cover * cover);
    surface.areas[point] = area;
    surface.radii[point] = std::max(kCoverOverlap * cover, kAreaOverlap * std::sqrt(area));
    if (surface.normals[point].isZero()) surface.normals[point] = set.normals[site];
  }
  if (std::vector<float> given = radiiOfFile(points, surface.radii); !given.empty())
    surface.radii = std::move(given);
  return surface;
}

}  // namespace stipple
