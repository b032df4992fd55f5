#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>

#include "core/parallel.h"
#include "render/hierarchy/view.h"
#include "tests/support/picture_errors.h"

namespace stipple {

/// What a viewer without any structure does: all points as GL_POINTS of one pixel from one static buffer
/// (position, normal, color; 28 bytes a point), shaded like ours, in an OpenGL 4.5 context without a window
/// system.
class NaivePoints {
 public:
  /// Throws IoError where there is no such context. `order`: which point stands where in the buffer; empty:
  /// as given.
  NaivePoints(const scenes::SurfaceSamples& samples, std::span<const Index> order);
  ~NaivePoints();
  NaivePoints(const NaivePoints&) = delete;
  NaivePoints& operator=(const NaivePoints&) = delete;

  /// Draws and waits until the picture is there; it is not read back.
  void draw(const View& view, const Rgba8& background);
  /// Of the last frame. Depth is 0 where a point was drawn.
  DrawnPicture picture() const;
  /// Renderer and version of OpenGL.
  std::string device() const;

 private:
  struct Context;
  struct Buffer;
  std::shared_ptr<Context> context_;  // one for all
  std::unique_ptr<Buffer> buffer_;
};

}  // namespace stipple
