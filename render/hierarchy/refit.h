#pragma once

#include <span>
#include <vector>

#include "core/progress.h"
#include "render/hierarchy/hierarchy.h"

namespace stipple {

/// Nodes [begin, end) that changed: what a back end uploads.
struct NodeRange {
  Index begin = 0, end = 0;
  friend bool operator==(const NodeRange&, const NodeRange&) = default;
};

/// Aggregates every inner node anew, from the level `lowest` on.
void refitAll(Hierarchy& hierarchy, const Progress* progress = nullptr, int lowest = 1);

/// Aggregates the lower `levels` levels over the leaves [begin, end), which are whole subtrees of that
/// height, but for the last.
void refitLeaves(Hierarchy& hierarchy, std::size_t begin, std::size_t end, int levels);

/// Aggregates the ancestors of leaves that were changed (slots in any order), level by level. Same bits as
/// refitAll. Returns the changed nodes, leaves included, ascending and coalesced across small gaps.
std::vector<NodeRange> refit(Hierarchy& hierarchy, std::span<const Index> slots);

/// A parent's splat and bound from its children (1 to 4 of them); `first` is a node, inner or leaf.
void aggregate(Hierarchy& hierarchy, Index parent, Index first, Index count);

}  // namespace stipple
