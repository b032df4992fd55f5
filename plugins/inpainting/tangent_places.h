#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/sites.h"

namespace stipple {

/// Where the neighbors of each site lie in its tangent plane: at their distance in space, in the direction of
/// their projection. What is steeper than about 50 degrees above the plane (another sheet) is left out.
struct TangentPlaces {
  float spacing = 1;                       ///< model units; the unit of places
  std::vector<Eigen::Vector3f> positions;  ///< m x 3, in Morton order
  std::vector<Eigen::Matrix3f> frames;     ///< columns: two tangents, the normal
  std::vector<std::size_t> offsets;        ///< m + 1
  std::vector<Index> neighbors;            ///< nearest first, without the site itself
  std::vector<Eigen::Vector2f> places;     ///< parallel to neighbors, in units of the spacing

  Index size() const { return static_cast<Index>(positions.size()); }
  std::span<const Index> of(Index site) const {
    return {neighbors.data() + offsets[site], offsets[site + 1] - offsets[site]};
  }
  std::span<const Eigen::Vector2f> placesOf(Index site) const {
    return {places.data() + offsets[site], offsets[site + 1] - offsets[site]};
  }
  /// Of a position near the site.
  Eigen::Vector2f placeOf(Index site, const Eigen::Vector3f& position) const;
  /// The neighbor of the site, or the site, that is nearest to a place in its tangent plane.
  Index nearest(Index site, const Eigen::Vector2f& place) const;
};

/// Frames that turn as little as they can from site to site: carried over the surface from `start` along
/// shortest paths (discrete exponential map, Schmidt et al. 2006), so that patches near each other are
/// compared in one orientation. Parts that no path reaches begin with a frame of their own.
std::vector<Eigen::Matrix3f> carryFrames(const Sites& sites, Index start, const Progress* progress = nullptr);

/// Throws Cancelled.
TangentPlaces findTangentPlaces(const Sites& sites, std::vector<Eigen::Matrix3f> frames, float spacing,
                                const Progress* progress = nullptr);

}  // namespace stipple
