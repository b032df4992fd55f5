#pragma once

#include <span>
#include <vector>

#include "render/hierarchy/hierarchy.h"

namespace stipple {

/// Without the nodes that are hidden in a picture and stay so when it is shifted by up to a pixel: those that
/// lie farther behind all that is seen about them than discs blend. `depth` is that of the picture of `view`
/// (Renderer::depth: rows from the top, infinite where the background shows). Keeps the order.
std::vector<Index> withoutHidden(const Hierarchy& hierarchy, std::span<const Index> nodes, const View& view,
                                 std::span<const float> depth);

}  // namespace stipple
