#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/fans.h"
#include "core/points/point_set.h"

namespace stipple {

/// A triangle that is not in the fans of all three corners; corners ascending.
struct VotedTriangle {
  Triangle corners;
  int votes;  ///< fans that have it: 1 or 2
};

/// True where the fan of `site` has a triangle with a and b, in either order.
bool hasTriangle(const Fans& fans, Index site, Index a, Index b);

/// Triangles that are not in the fans of all three corners, in patches: two that share a corner belong to the
/// same one.
struct DisputedPatches {
  std::vector<VotedTriangle> triangles;
  std::vector<std::size_t> begins{0};  ///< patches + 1

  std::size_t size() const { return begins.size() - 1; }
  std::span<const VotedTriangle> of(std::size_t patch) const {
    return std::span(triangles).subspan(begins[patch], begins[patch + 1] - begins[patch]);
  }
};
/// `settled`, where given, gets the triangles that stand in the fans of all three corners, once each: the
/// least corner first, in the sense of its fan.
DisputedPatches findDisputed(const Fans& fans, const Progress* progress,
                             std::vector<Triangle>* settled = nullptr);

/// Share of triangle instances that stand in the fans of all three corners.
double shareOfConsistentTriangles(const Fans& fans);

}  // namespace stipple
