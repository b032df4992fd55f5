#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/local_fan.h"
#include "core/geometry/neighborhoods.h"

namespace stipple {

/// Where a neighbor lies in the tangent plane: at its distance in space (unfolded), or projected orthogonally.
enum class Metric { kUnfolded, kProjected };

/// One Delaunay star per site: its neighbors in cyclic order about the normal. Compressed rows.
struct Fans {
  static constexpr std::uint8_t kGapAfter = 1;  ///< no triangle between this neighbor and the next
  std::vector<Index> offsets{0};                ///< m + 1
  std::vector<Index> neighbors;
  std::vector<std::uint8_t> flags;              ///< parallel to neighbors
  std::vector<std::uint8_t> open;               ///< m: the star does not close round its site
  std::vector<std::uint8_t> certified;          ///< m: no site beyond those looked at can change it

  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
  std::span<const Index> of(Index site) const {
    return {neighbors.data() + offsets[site], offsets[site + 1] - offsets[site]};
  }
  std::span<const std::uint8_t> flagsOf(Index site) const {
    return {flags.data() + offsets[site], offsets[site + 1] - offsets[site]};
  }
};

struct FanOptions {
  Metric metric = Metric::kUnfolded;
  int frameNeighbors = 16;  ///< of the tangent plane
  int k = 24;               ///< neighbors that a fan starts with
  int maxK = 64;            ///< an uncertified fan looks at twice as many until here
  double minAngle = 0;      ///< radians
};

/// Processor seconds by what they were spent on; loops are fused, so the wall clock is that of the whole.
struct FanTimes {
  double seconds = 0, neighbors = 0, frames = 0, fans = 0;
};

struct FanSet {
  Fans fans;
  std::vector<Eigen::Vector3f> normals;  ///< m x 3, unit, sign arbitrary
  FanTimes times;
};

/// Neighbors, tangent plane and star of every site, block by block, so that neighborhoods never stand in memory.
FanSet buildFans(const Sites& sites, const FanOptions& options, const Progress* progress = nullptr);

/// Coordinates of neighbors in the tangent plane of a site, by ascending norm; what lies straight above it is left out.
/// `shifts` (may be empty) break ties: one small vector a site, the same in every fan.
void mapToTangentPlane(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> shifts, Index site,
                       const Eigen::Vector3f& normal, std::span<const Index> neighbors, Metric metric,
                       std::vector<PlanePoint>& points);

/// A shift for every site, hashed from its position, 1e-6 of the distance to the next site in spatial order: without it
/// fans of a grid choose their diagonals each by itself.
std::vector<Eigen::Vector3f> tieBreakShifts(std::span<const Eigen::Vector3f> positions);

}  // namespace stipple
