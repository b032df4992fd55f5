#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/points/point_set.h"
#include "core/progress.h"
#include "render/appearance/surface_mesh.h"
#include "render/hierarchy/hierarchy.h"
#include "render/hierarchy/refit.h"
#include "render/raster/glyphs.h"

namespace stipple {

/// Bounds of a point set: the sphere that a camera frames, and how far neighbors are apart.
struct Extent {
  FramingSphere sphere;
  float spacing = 0;  ///< estimated, world units
};
Extent measureExtent(const PointSet& points);

/// A better hierarchy of the same points, made aside: kd order, discs and normals from local fans, and
/// whether the model is closed. `colors` by point. Takes up to kRefinementBytes a point.
Hierarchy refineHierarchy(const PointSet& points, std::span<const Rgba8> colors, const Progress* progress);
inline constexpr std::size_t kRefinementBytes = 900;

/// The hierarchy of what is shown, which follows the points: colors of some rows, of all, positions. It holds
/// no column of the point set. Every change ends in a refit, and the ranges that changed are to be uploaded.
class DisplayedSurface {
 public:
  DisplayedSurface() = default;
  /// Morton order, discs from blocks of leaves: what the first picture is made of. `colors` by point.
  DisplayedSurface(const PointSet& points, std::span<const Rgba8> colors, const Progress* progress);

  const Hierarchy& hierarchy() const { return hierarchy_; }
  Index size() const { return hierarchy_.leafCount(); }

  /// Puts a better hierarchy of the same points in place. The points `recolored` take their colors from this
  /// one; nothing: all do.
  void adopt(Hierarchy refined, const std::optional<std::vector<Index>>& recolored);
  std::vector<NodeRange> recolor(std::span<const Index> rows, std::span<const Rgba8> colors);
  std::vector<NodeRange> recolorAll(std::span<const Rgba8> colors);
  /// For hierarchies that are too large to be made a second time: brings the next block of leaves into kd
  /// order.
  std::vector<NodeRange> sortNext();
  bool isSorted() const { return isSorted_; }
  /// Whether the model is closed; `points` are those that are shown. Throws Cancelled.
  void askClosedness(const PointSet& points, const Progress* progress);
  /// Takes positions anew, and normals where the points have them; discs stay as they are.
  std::vector<NodeRange> move(const PointSet& points);

 private:
  Hierarchy hierarchy_;
  Index sortedBlocks_ = 0;
  bool isSorted_ = true, hasBlockNormals_ = false;
};

}  // namespace stipple
