#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/geometry/nearest_points.h"
#include "core/geometry/neighborhoods.h"
#include "core/points/point_set.h"

namespace stipple {

/// A site and its distance along the surface, in model units.
struct Reached {
  Index site;
  float distance;
};

/// Answers which points lie near a place along the surface: shortest paths over the graph of the 12 nearest
/// neighbors. Paths are a few percent longer than geodesics. Owns all that it needs; threads may share it.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const PointSet& points, const Progress* progress = nullptr);
  ~SurfaceDistance();
  SurfaceDistance(const SurfaceDistance&) = delete;
  SurfaceDistance& operator=(const SurfaceDistance&) = delete;

  const Sites& sites() const { return sites_; }
  /// All file rows of a site.
  std::span<const Index> pointsOf(Index site) const {
    return std::span(points_).subspan(offsets_[site], offsets_[site + 1] - offsets_[site]);
  }
  /// Those that a site is joined to in the graph, nearest first.
  std::span<const Index> neighborsOf(Index site) const { return neighborhoods_.of(site); }
  /// The site nearest to a place in space. There must be one.
  Index findNearest(const Eigen::Vector3f& place) const;
  /// The sites within `radius` of `start` along the surface, itself first, by rising distance.
  std::vector<Reached> findWithin(Index start, float radius) const;
  /// The sites of a shortest path, both ends included; empty where none leads there.
  std::vector<Index> findPath(Index start, Index end) const;

 private:
  struct Fronts;

  Sites sites_;
  std::vector<Index> offsets_, points_;  // file rows by site, in compressed rows
  Neighborhoods neighborhoods_;
  std::unique_ptr<NearestPoint> nearest_;  // null where there are no sites
  std::unique_ptr<Fronts> fronts_;
};

}  // namespace stipple
