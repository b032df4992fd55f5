#pragma once

#include "render/gl/framebuffer.h"
#include "render/gl/texture2d.h"

namespace stipple {

/// What the passes of a frame of one size draw to.
class FrameTargets {
 public:
  FrameTargets() = default;
  FrameTargets(int width, int height);

  int width() const { return visible.width(); }
  int height() const { return visible.height(); }

  gl::Texture2D visible;  ///< node, normal, color, depth, see shaders/visibility.frag
  gl::Texture2D depth;
  gl::Texture2D colorSum, normalSum;  ///< see shaders/attributes.frag
  gl::Framebuffer visibility, sums;
  gl::Framebuffer mesh;  ///< visible texels and both sums
};

/// What is kept of all frames since the last new start, and the picture made of it.
class PictureTargets {
 public:
  PictureTargets() = default;
  PictureTargets(int width, int height);

  int width() const { return mean.width(); }
  int height() const { return mean.height(); }

  gl::Texture2D mean;     ///< linear, premultiplied
  gl::Texture2D encoded;  ///< sRGB, straight alpha
  gl::Framebuffer accumulation, encoding;
};

}  // namespace stipple
