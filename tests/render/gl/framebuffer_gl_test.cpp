#include "render/gl/framebuffer.h"

#include <vector>

#include "render/gl/pipeline.h"
#include "render/gl/program.h"
#include "render/gl/shader_source.h"
#include "render/gl/vertex_array.h"
#include "tests/support/gl_fixture.h"

namespace stipple {
namespace {

using FramebufferTest = GlTest;
using Pixel = std::array<float, 4>;

std::vector<Pixel> pixelsOf(const gl::Texture2D& texture) {
  std::vector<Pixel> pixels(static_cast<std::size_t>(texture.width()) * texture.height());
  texture.read(0, 0, texture.width(), texture.height(), std::as_writable_bytes(std::span(pixels)));
  return pixels;
}

TEST_F(FramebufferTest, ClearsEveryAttachmentByItself) {
  const gl::Texture2D color(gl::Format::kRgba32F, 5, 3), ids(gl::Format::kRgba32Ui, 5, 3);
  const gl::Texture2D depth(gl::Format::kDepth32F, 5, 3);
  gl::Framebuffer target({&color, &ids}, &depth);
  gl::apply({.depth = gl::DepthTest::kNearest});
  target.clearColor(0, Pixel{1, 2, 3, 4});
  target.clearColor(1, std::array<std::uint32_t, 4>{0xffffffff, 1, 2, 3});
  target.clearDepth(0.25f);
  EXPECT_EQ(pixelsOf(color), std::vector<Pixel>(15, Pixel{1, 2, 3, 4}));
  std::array<std::uint32_t, 4> id{};
  ids.read(4, 2, 1, 1, std::as_writable_bytes(std::span(id)));
  EXPECT_EQ(id, (std::array<std::uint32_t, 4>{0xffffffff, 1, 2, 3}));
  float kept = 0;
  depth.read(0, 0, 1, 1, std::as_writable_bytes(std::span(&kept, 1)));
  EXPECT_EQ(kept, 0.25f);
}

TEST_F(FramebufferTest, TheCallersTargetComesBack) {
  const gl::Texture2D first(gl::Format::kRgba8, 4, 4), second(gl::Format::kRgba8, 2, 2);
  const gl::Framebuffer theirs({&first}), ours({&second});
  theirs.bind();
  {
    const gl::CallersTarget callers;
    EXPECT_EQ(callers.drawName(), theirs.name());
    ours.bind();
  }
  EXPECT_EQ(gl::CallersTarget().drawName(), theirs.name());
}

TEST_F(FramebufferTest, ABlitTurnsTheFirstRowToTheTop) {
  const gl::Texture2D from(gl::Format::kRgba32F, 2, 2), to(gl::Format::kRgba32F, 2, 2);
  gl::Framebuffer source({&from}), target({&to});
  gl::apply({});
  source.clearColor(0, Pixel{1, 0, 0, 1});
  target.clearColor(0, Pixel{0, 0, 0, 0});
  gl::blitFlipped(source, 2, 1, target.name());  // only the first row, to the lowest one
  EXPECT_EQ(pixelsOf(to)[0], (Pixel{1, 0, 0, 1}));
  EXPECT_EQ(pixelsOf(to)[2], (Pixel{0, 0, 0, 0}));
}

TEST_F(FramebufferTest, LargerThanTheCardAllowsIsInvalid) {
  EXPECT_THROW(gl::Texture2D(gl::Format::kRgba8, 1 << 20, 1), InvalidInput);
  EXPECT_THROW(gl::Texture2D(gl::Format::kRgba8, 0, 1), InvalidInput);
}

}  // namespace
}  // namespace stipple
