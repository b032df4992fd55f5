#pragma once

#include <memory>
#include <vector>

#include "core/geometry/neighborhoods.h"
#include "core/points/point_set.h"

namespace stipple {

/// A site and its distance along the surface, in model units.
struct Reached {
  Index site;
  float distance;
};

/// Answers which points lie near a place along the surface: shortest paths over the graph of the 12 nearest
/// neighbors. Paths are a few percent longer than geodesics. Owns all that it needs.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const PointSet& points, const Progress* progress = nullptr);
  ~SurfaceDistance();
  SurfaceDistance(const SurfaceDistance&) = delete;
  SurfaceDistance& operator=(const SurfaceDistance&) = delete;

  const Sites& sites() const { return sites_; }
  /// The site nearest to a place in space. There must be one.
  Index findNearest(const Eigen::Vector3f& place) const;
  /// The sites within `radius` of `start` along the surface, itself first, by rising distance.
  std::vector<Reached> findWithin(Index start, float radius) const;
  /// The sites of a shortest path, both ends included; empty where none leads there.
  std::vector<Index> findPath(Index start, Index end) const;

 private:
  struct Tree;

  Sites sites_;
  Neighborhoods neighborhoods_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace stipple
