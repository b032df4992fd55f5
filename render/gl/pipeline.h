#pragma once

#include <cstdint>

namespace stipple::gl {

/// nearest: what has the greater depth value is drawn, and its depth kept. notBehind: what has a depth value
/// at least as great is drawn, and no depth kept.
enum class DepthTest { kNone, kNearest, kNotBehind };

/// replace: as drawn. sum: added. mean: `meanWeight` of what is drawn, the rest of what was there.
enum class Blend { kReplace, kSum, kMean };

/// All state of the fixed stages that a pass relies on.
struct Pipeline {
  DepthTest depth = DepthTest::kNone;
  Blend blend = Blend::kReplace;
  float meanWeight = 1;
  int clipDistances = 0;
};

/// Sets all of it, whatever the state was, so that clears and draws reach every pixel of the framebuffer.
/// Depths are clipped to [0, 1].
void apply(const Pipeline& pipeline);

/// Draws triangles whose corners the vertex shader makes of gl_VertexID alone.
void drawTriangles(std::uint32_t triangles);

}  // namespace stipple::gl
