#pragma once

#include <limits>
#include <span>
#include <vector>

#include "plugins/segmentation/surface_graph.h"

namespace stipple {

inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Lowers `distance` (model units, kUnreached where nothing has been reached) to that from `sources`, along edges that
/// are not blocked. Calling it again with more sources continues.
void spreadDistance(const SurfaceGraph& graph, std::span<const Index> sources, std::vector<float>& distance);

/// The sites within `radius` of one site along edges that are not blocked, itself included, ascending.
std::vector<Index> discAround(const SurfaceGraph& graph, Index center, float radius);

/// Gives every site without a label (0) that of the nearest labelled one along edges that are not blocked. A
/// piece with no label at all takes, as a whole, the one that most of the edges across its border lead to: that
/// does not hang on a single edge. Sites that no path joins to a label keep 0.
void fillFromNearest(const SurfaceGraph& graph, std::vector<std::int32_t>& labels);

}  // namespace stipple
