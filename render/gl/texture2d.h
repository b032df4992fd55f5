#pragma once

#include <cstddef>
#include <span>

#include "render/gl/object_name.h"

namespace stipple::gl {

void destroyTexture(unsigned name);

enum class Format { kRgba8, kRgba16F, kRgba32F, kRgba32Ui, kDepth32F };

/// A picture on the graphics card without mipmaps, read texel by texel.
class Texture2D {
 public:
  Texture2D() = default;
  /// Throws IoError where the card has no room for it, InvalidInput where it is larger than the card allows.
  Texture2D(Format format, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  Format format() const { return format_; }
  unsigned name() const { return name_.get(); }

  void bind(unsigned unit) const;
  /// The texels of a rectangle, row by row, in the texture's own format (4 bytes, 4 floats, 4 integers a
  /// texel). Waits for the card.
  void read(int x, int y, int width, int height, std::span<std::byte> texels) const;

 private:
  ObjectName<destroyTexture> name_;
  Format format_ = Format::kRgba8;
  int width_ = 0, height_ = 0;
};

}  // namespace stipple::gl
