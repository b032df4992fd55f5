#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/points/point_set.h"
#include "core/progress.h"
#include "render/hierarchy/hierarchy.h"

namespace stipple {

/// Whether backs are never seen from outside, so that Hierarchy::isClosedAndOriented may be set: the discs of
/// the leaves enclose what lies behind them, and the triangles, where there are any, have no border, use
/// every point and agree with the normals. Says no where it is in doubt. Gaps count from about two discs on,
/// or from 1/300 of the extent. For a worker: some seconds for 10 M points. Throws Cancelled.
bool isClosedAndOriented(const PointSet& points, const Hierarchy& hierarchy,
                         const Progress* progress = nullptr);

/// Whether every edge belongs to two triangles that run through it in opposite directions, and every one of
/// `points` points to a triangle. Triangles that have a corner twice are left out.
bool areClosed(std::span<const Triangle> triangles, Index points);

/// Whether a place lies inside of a closed and oriented model, by its winding number; close to the surface
/// either may be said. Looks at a few nodes only.
bool isInside(const Hierarchy& hierarchy, const glm::vec3& place);

}  // namespace stipple
