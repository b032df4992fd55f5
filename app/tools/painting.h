#pragma once

#include <memory>
#include <optional>
#include <span>

#include "app/document/document.h"
#include "app/document/stroke_painter.h"

namespace stipple {

/// A stroke that is being laid down on a document: one entry of its history when it ends.
class Painting {
 public:
  bool isActive() const { return painter_.has_value(); }
  /// Throws InvalidInput, beginning nothing, where the stroke does not suit the points. `filter` leaves out
  /// points for reasons that only a view knows; where it does, the stroke is no step of a recipe.
  void begin(Document& document, std::shared_ptr<const SurfaceDistance> surface, const Stroke& stroke,
             PointFilter filter = {});
  void lay(Document& document, std::span<const Dab> dabs);
  void end(Document& document);
  /// Everything is as before.
  void cancel(Document& document);

 private:
  std::optional<StrokePainter> painter_;
  Stroke stroke_;  // with the dabs so far
  PointFilter filter_;
  std::shared_ptr<bool> leftOut_;  // whether the filter has left out a point
};

}  // namespace stipple
