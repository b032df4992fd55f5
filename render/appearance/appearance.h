#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/points/attribute.h"

namespace stipple {

/// splats: ellipses blended where they overlap. discs: the nearest ellipse alone. points: one pixel each.
enum class SplatMode { kSplats, kDiscs, kPoints };

/// A ball on the surface that shows where a brush acts.
struct BrushRing {
  glm::vec3 center{};  ///< world
  float radius = 0;    ///< world
  Rgba8 color{255, 255, 255, 255};
};

/// How splats look, apart from their own colors. Light comes from over the viewer's shoulder.
struct Appearance {
  SplatMode mode = SplatMode::kSplats;
  std::optional<Rgba8> background = Rgba8{43, 43, 46, 255};  ///< none: transparent
  bool twoSided = true;       ///< faces seen from behind are lit like those seen from in front
  bool lit = true;            ///< false: colors as they are
  float edgeStrength = 0.6f;  ///< eye-dome lighting, 0: off
  /// The frame is one of many, shifted by parts of a pixel, whose mean is shown: discs cover what is theirs
  /// and no whole pixels.
  bool isOneOfMany = false;
  Rgba8 selectionColor{255, 152, 26, 255};
  std::optional<BrushRing> brush = {};
};

}  // namespace stipple
