#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/progress.h"
#include "render/hierarchy/hierarchy.h"
#include "render/hierarchy/raw_vector.h"

namespace stipple {

/// morton: at once, for the first picture. kd: nodes of half the size, takes longer.
enum class LeafOrder { kMorton, kKd };

/// What a leaf shows, by point. Empty spans: radii, areas and normals are estimated from blocks of
/// neighboring leaves (see block_estimates.h), colors are light gray.
struct LeafAttributes {
  std::span<const Eigen::Vector3f> positions;
  std::span<const float> radii;  ///< of the discs
  std::span<const float> areas;  ///< of the surface that a point stands for; empty: from the radii
  std::span<const Eigen::Vector3f> normals;  ///< any length; 0: estimated
  std::span<const Rgba8> colors;             ///< alpha: how much is selected
};

/// Orders the points, fills the leaves and aggregates all levels. Throws Cancelled.
Hierarchy buildHierarchy(const LeafAttributes& leaves, LeafOrder order, const Progress* progress = nullptr);

/// A point and where it is.
struct PlacedPoint {
  Eigen::Vector3f position;
  Index point;
};

/// The points slot by slot: left-balanced kd order (median splits at powers of two along the longest axis),
/// or along the Morton curve.
RawVector<PlacedPoint> orderLeaves(std::span<const Eigen::Vector3f> positions, LeafOrder order,
                                   const Progress* progress = nullptr);

/// Left-balanced kd order of these points, in place.
void sortByKdOrder(std::span<PlacedPoint> points, const Progress* progress = nullptr);

}  // namespace stipple
