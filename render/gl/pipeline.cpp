#include "render/gl/pipeline.h"

#include <epoxy/gl.h>

#include <initializer_list>

namespace stipple::gl {

namespace {

void enable(GLenum capability, bool on) {
  if (on) {
    glEnable(capability);
  } else {
    glDisable(capability);
  }
}

void applyBlend(const Pipeline& pipeline) {
  enable(GL_BLEND, pipeline.blend != Blend::kReplace);
  glBlendEquation(GL_FUNC_ADD);
  if (pipeline.blend == Blend::kSum) glBlendFunc(GL_ONE, GL_ONE);
  if (pipeline.blend == Blend::kMean) {
    glBlendColor(0, 0, 0, pipeline.meanWeight);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  }
}

}  // namespace

void apply(const Pipeline& pipeline) {
  for (const GLenum off :
       {GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL, GL_RASTERIZER_DISCARD,
        GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_MASK, GL_COLOR_LOGIC_OP, GL_FRAMEBUFFER_SRGB, GL_DITHER,
        GL_DEPTH_CLAMP, GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX}) {
    glDisable(static_cast<GLenum>(off));
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glDepthRange(0, 1);

  enable(GL_DEPTH_TEST, pipeline.depth != DepthTest::kNone);
  glDepthMask(pipeline.depth == DepthTest::kNearest);
  glDepthFunc(pipeline.depth == DepthTest::kNearest ? GL_GREATER : GL_GEQUAL);
  applyBlend(pipeline);
  constexpr int kClipDistances = 8;  // as many as every 4.5 context has
  for (int i = 0; i < kClipDistances; ++i) {
    enable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i), i < pipeline.clipDistances);
  }
}

void drawTriangles(std::uint32_t triangles) {
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * triangles));
}

}  // namespace stipple::gl
