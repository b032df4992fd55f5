#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/gl/object_name.h"
#include "render/gl/texture2d.h"

namespace stipple::gl {

void destroyFramebuffer(unsigned name);

/// Where a pass draws to: textures of one size, which must outlive it.
class Framebuffer {
 public:
  Framebuffer() = default;
  explicit Framebuffer(const std::vector<const Texture2D*>& colors, const Texture2D* depth = nullptr);

  unsigned name() const { return name_.get(); }
  /// Draws go here from now on, to the whole of it.
  void bind() const;
  void clearColor(int attachment, const std::array<float, 4>& color);
  void clearColor(int attachment, const std::array<std::uint32_t, 4>& color);
  void clearDepth(float depth);

 private:
  ObjectName<destroyFramebuffer> name_;
  int width_ = 0, height_ = 0;
};

/// Puts the caller's framebuffers, viewport and clipping convention back when it ends.
class CallersTarget {
 public:
  CallersTarget();
  ~CallersTarget();
  CallersTarget(const CallersTarget&) = delete;
  CallersTarget& operator=(const CallersTarget&) = delete;

  unsigned drawName() const { return static_cast<unsigned>(draw_); }

 private:
  int draw_ = 0, read_ = 0;
  std::array<int, 4> viewport_{};
  int clipOrigin_ = 0, clipDepth_ = 0;
};

/// Copies the first color attachment into the framebuffer `target`, upside down: its first row comes to the
/// top.
void blitFlipped(const Framebuffer& source, int width, int height, unsigned target);

}  // namespace stipple::gl
