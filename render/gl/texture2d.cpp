#include "render/gl/texture2d.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cassert>

#include "core/error.h"
#include "render/gl/debug_messages.h"

namespace stipple::gl {

namespace {

// How texels are stored, and how they are read back.
struct Layout {
  GLenum stored, channels, type;
};

Layout layoutOf(Format format) {
  switch (format) {
    case Format::kRgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Format::kRgba16F:
      return {GL_RGBA16F, GL_RGBA, GL_FLOAT};
    case Format::kRgba32F:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case Format::kRgba32Ui:
      return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    case Format::kDepth32F:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  assert(false);
  return {};
}

}  // namespace

void destroyTexture(unsigned name) {
  glDeleteTextures(1, &name);
}

Texture2D::Texture2D(Format format, int width, int height) : format_(format), width_(width), height_(height) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (width < 1 || height < 1 || width > largest || height > largest) {
    throw InvalidInput(fmt::format("a picture of {} x {} pixels, this graphics card takes 1 to {} each way",
                                   width, height, largest));
  }
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  name_ = ObjectName<destroyTexture>(name);
  forgetErrors();
  glTextureStorage2D(name, 1, layoutOf(format).stored, width, height);
  if (glGetError() == GL_OUT_OF_MEMORY) {
    throw IoError(fmt::format("the graphics card has no room left for {} x {} pixels", width, height));
  }
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture2D::bind(unsigned unit) const {
  glBindTextureUnit(unit, name());
  // A sampler left on the unit would override the texture's own parameters.
  glBindSampler(unit, 0);
}

void Texture2D::read(int x, int y, int width, int height, std::span<std::byte> texels) const {
  const Layout layout = layoutOf(format_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glPixelStorei(GL_PACK_SKIP_ROWS, 0);
  glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glGetTextureSubImage(name(), 0, x, y, 0, width, height, 1, layout.channels, layout.type,
                       static_cast<GLsizei>(texels.size()), texels.data());
}

}  // namespace stipple::gl
