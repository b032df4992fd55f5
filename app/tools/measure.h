#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/document/surface_distance.h"

namespace stipple {

/// The distance of two places on a surface, in model units.
struct Measurement {
  double straight = 0;
  /// Along the surface, a few percent too long; nothing where no path leads there.
  std::optional<double> alongSurface = {};
  std::vector<glm::vec3> path = {};  ///< world; from the one place to the other, to be drawn. Empty: no path
};

/// Places in world coordinates, as they were picked; they are joined to the sites nearest to them. There must
/// be points.
Measurement measure(const SurfaceDistance& surface, const glm::vec3& from, const glm::vec3& to);

}  // namespace stipple
