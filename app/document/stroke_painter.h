#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/document/stroke.h"
#include "app/document/surface_distance.h"
#include "core/points/edit.h"

namespace stipple {

/// Of the points that a dab reaches, those that it may change; empty: all. For what only a view knows, such
/// as which points are seen. A stroke that was laid down through a filter cannot be done again without the
/// view and so is no step of a recipe.
using PointFilter = std::function<bool(Index point)>;

/// Checks a stroke against the points and makes its attribute where it is missing. Returns whether it did.
/// Throws InvalidInput, changing nothing, as applyStroke does.
bool prepareStroke(PointSet& points, const Stroke& stroke);

/// Lays a stroke down dab by dab, as it is drawn: the same bits as applyStroke with all of its dabs.
class StrokePainter {
 public:
  /// `surface` was built from the positions of the points that will be painted. The dabs of `stroke` are not
  /// looked at.
  StrokePainter(std::shared_ptr<const SurfaceDistance> surface, Stroke stroke);

  const Stroke& stroke() const { return stroke_; }
  /// Returns what changed, as Document::paint asks for it. Throws InvalidInput, changing nothing, as
  /// applyStroke does.
  std::vector<Edit::Touched> lay(PointSet& points, const Dab& dab, const PointFilter& filter = {}) const;

 private:
  std::shared_ptr<const SurfaceDistance> surface_;
  Stroke stroke_;
};

}  // namespace stipple
