#pragma once

#include <span>
#include <vector>

#include "render/hierarchy/hierarchy.h"

namespace stipple {

struct Ball {
  glm::vec3 center{};  ///< world
  float radius = 0;    ///< world units
};

/// Slots of the leaves whose centers lie in the ball, ascending.
std::vector<Index> findInBall(const Hierarchy& hierarchy, const Ball& ball);

/// Of those the ones that are seen: projected into the picture, at most `tolerance` (world units) and their
/// own disc behind the depth that it has there (rows from the top, infinite where nothing was drawn).
std::vector<Index> findVisibleInBall(const Hierarchy& hierarchy, const Ball& ball, const View& view,
                                     std::span<const float> depth, float tolerance);

/// The leaf under a node of a cut that is nearest to a place: what a click on that node means.
Index nearestLeaf(const Hierarchy& hierarchy, Index node, const glm::vec3& place);

}  // namespace stipple
