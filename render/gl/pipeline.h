#pragma once

#include <cstdint>

namespace stipple::gl {

/// replace: as drawn. sum: added. mean: `meanWeight` of what is drawn, the rest of what was there.
enum class Blend { kReplace, kSum, kMean };

/// All state of the fixed stages that a pass relies on.
struct Pipeline {
  bool depthTest = false;  ///< the greater depth wins and is written
  Blend blend = Blend::kReplace;
  float meanWeight = 1;
  int clipDistances = 0;
};

/// Sets all of it, whatever the state was, so that clears and draws reach every pixel of the framebuffer.
/// Nothing that is left behind changes what a fresh context draws, except for depth test and blending.
void apply(const Pipeline& pipeline);

/// Draws triangles whose corners the vertex shader makes of gl_VertexID alone.
void drawTriangles(std::uint32_t triangles);

}  // namespace stipple::gl
