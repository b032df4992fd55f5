#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/points/point_set.h"
#include "core/progress.h"
#include "render/appearance/image.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// A line from a point along its vector (the paper's Fig. 2); world.
struct Glyph {
  glm::vec3 from{}, to{};
};

struct GlyphOptions {
  Index count = 2000;  ///< about how many points get one; all where there are no more
  float length =
      1;  ///< of the longest lines (those of the upper twentieth are cut), in distances between glyphs
};

/// Lines for points that are spread evenly, as long as their vectors are in comparison. Points whose vector
/// is 0 or not finite get none. Same result for the same points. Throws InvalidInput where the attribute is
/// missing or no vector3, Cancelled.
std::vector<Glyph> makeGlyphs(const PointSet& points, const std::string& attribute,
                              const GlyphOptions& options, const Progress* progress = nullptr);

/// Draws antialiased lines of a bit more than a pixel over a finished picture, where they are not behind
/// `depth` (by pixel, infinite where there is nothing; empty: all are seen).
void drawGlyphs(Image& image, std::span<const float> depth, const View& view, std::span<const Glyph> glyphs,
                const Rgba8& color);

}  // namespace stipple
