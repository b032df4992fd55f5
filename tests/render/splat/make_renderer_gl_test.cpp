#include <string>

#include "core/error.h"
#include "render/gl/framebuffer.h"
#include "render/gl/pipeline.h"
#include "render/splat/gl_renderer.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/splat_scenes.h"

namespace stipple {
namespace {

TEST(MakeRenderer, WithoutAContextIsTheProcessors) {
  EXPECT_STREQ(makeRenderer(Backend::kAuto)->backend(), "cpu");
  EXPECT_STREQ(makeRenderer(Backend::kCpu)->backend(), "cpu");
  EXPECT_THROW(makeRenderer(Backend::kGl), IoError);
}

using MakeRendererTest = GlTest;

TEST_F(MakeRendererTest, TakesOpenGlOnHardwareByItself) {
  EXPECT_STREQ(makeRenderer(Backend::kAuto)->backend(), context_->isSoftware() ? "cpu" : "gl");
  EXPECT_STREQ(makeRenderer(Backend::kGl)->backend(), "gl");
  EXPECT_STREQ(makeRenderer(Backend::kCpu)->backend(), "cpu");
}

// As a window does it: somebody else's framebuffer is bound.
class PresentTest : public GlTest {
 protected:
  using Pixel = std::array<std::uint8_t, 4>;
  static std::vector<Pixel> pixelsOf(const gl::Texture2D& texture) {
    std::vector<Pixel> pixels(static_cast<std::size_t>(texture.width()) * texture.height());
    texture.read(0, 0, texture.width(), texture.height(), std::as_writable_bytes(std::span(pixels)));
    return pixels;
  }
};

TEST_F(PresentTest, ShowsThePictureInTheBoundFramebuffer) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::torus(5'000));
  const View view = frameView({.radius = 1.4f}, {.pitch = 0.5f}, 60, 40);
  const gl::Texture2D window(gl::Format::kRgba8, view.width, view.height);
  gl::Framebuffer target({&window});
  gl::apply({});
  target.clearColor(0, std::array<float, 4>{1, 0, 1, 1});
  target.bind();

  GlRenderer renderer;
  renderer.upload(hierarchy, scenes::allNodes(hierarchy));
  renderer.draw(hierarchy, scenes::allLeaves(hierarchy), view, {}, Accumulate::kStartAnew);
  EXPECT_EQ(pixelsOf(window), std::vector<Pixel>(2400, Pixel{255, 0, 255, 255}))
      << "drawing is not presenting";
  renderer.present();
  const Image image = renderer.image();
  EXPECT_EQ(gl::CallersTarget().drawName(), target.name());

  const std::vector<Pixel> shown = pixelsOf(window);  // rows from the bottom
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Pixel& pixel = shown[static_cast<std::size_t>(view.height - 1 - y) * view.width + x];
      EXPECT_EQ((Rgba8{pixel[0], pixel[1], pixel[2], pixel[3]}), image.at(x, y)) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace stipple
