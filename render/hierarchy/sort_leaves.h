#pragma once

#include <vector>

#include "render/hierarchy/hierarchy.h"
#include "render/hierarchy/refit.h"

namespace stipple {

/// Leaves of an aligned block that are sorted together: nodes up to its root are as small as those of a kd
/// order of everything.
inline constexpr int kSortedLevels = 8;
inline constexpr Index kSortedLeaves = Index{1} << (2 * kSortedLevels);

struct LeafSorting {
  bool fitsNormals = false;  ///< normals came from blocks of leaves, and are to come from the new ones
};

/// Brings the leaves of the block-th aligned block of kSortedLeaves into kd order among themselves, in place,
/// and aggregates what is above them. For hierarchies that are too large to be built a second time. Returns
/// the nodes that changed, ascending.
std::vector<NodeRange> sortLeaves(Hierarchy& hierarchy, Index block, const LeafSorting& options);

}  // namespace stipple
