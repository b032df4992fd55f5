#pragma once

#include <span>
#include <vector>

#include "app/tools/selection.h"
#include "core/geometry/neighborhoods.h"
#include "core/progress.h"

namespace stipple {

/// Which points are next to each other on the surface: the nearest neighbors, but for those across a gap.
struct NeighborGraph {
  Sites sites;
  Neighborhoods neighborhoods;
  /// m: how long an edge of the site may be. An edge counts where neither end finds it too long, so that a
  /// stray point is not tied to the surface that it looks for.
  std::vector<float> reach;
};

struct NeighborGraphOptions {
  int k = 8;
  float gap = 3;  ///< an edge is too long beyond this many mean distances to the neighbors
};

/// Throws as weldAndOrder and findNeighborhoods do; O(n log n), to be kept while the positions are the same.
NeighborGraph buildNeighborGraph(const PointSet& points, const NeighborGraphOptions& options = {},
                                 const Progress* progress = nullptr);

/// The selection and all points next to it.
SelectionMask grow(const NeighborGraph& graph, std::span<const std::uint8_t> selection);
/// The selection without the points next to others: what grows is not selected. Rims of the surface stay.
SelectionMask shrink(const NeighborGraph& graph, std::span<const std::uint8_t> selection);

/// Rows, ascending, of the connected part of the surface that this row is on.
std::vector<Index> findConnected(const NeighborGraph& graph, Index row);

}  // namespace stipple
