#pragma once

#include <Eigen/Core>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/progress.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// Points as a picture shows them. A point is seen where it lies in the picture and at most `tolerance`, or
/// three pixels if that is more, behind the depth that the picture has there.
struct SeenPoints {
  std::span<const Eigen::Vector3f> positions;  ///< world
  const View& view;
  /// Of the picture, rows from the top, infinite where nothing was drawn. Empty: what is hidden counts too.
  std::span<const float> depth = {};
  float tolerance = 0;  ///< world units, see visibilityTolerance
};

/// Points of one sheet are this far behind each other, splats being as large as they are.
inline float visibilityTolerance(float spacing) {
  return 2 * spacing;
}

/// Two opposite corners, pixels.
struct ScreenRectangle {
  glm::vec2 corner{}, opposite{};
};

/// The rows that are seen within the shape, ascending. Throws InvalidInput where the depth has not one value
/// a pixel, Cancelled.
std::vector<Index> findInRectangle(const SeenPoints& points, const ScreenRectangle& rectangle,
                                   const Progress* progress = nullptr);
/// A point is inside a polygon, which closes by itself, where the center of its pixel is (even-odd rule).
std::vector<Index> findInLasso(const SeenPoints& points, std::span<const glm::vec2> polygon,
                               const Progress* progress = nullptr);
/// The seen row nearest to a pixel position, at most `radiusPx` away; of equal ones the foremost.
std::optional<Index> findClicked(const SeenPoints& points, const glm::vec2& px, float radiusPx = 8);

}  // namespace stipple
