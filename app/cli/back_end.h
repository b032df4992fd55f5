#pragma once

#include <memory>

#include "render/splat/renderer.h"

namespace stipple {

/// A renderer, with the context that it needs.
class BackEnd {
 public:
  /// For kAuto `cpu` where there is no graphics hardware. Ends the command with kFailed where `gl` is asked
  /// for and cannot be had.
  explicit BackEnd(Backend backend);
  ~BackEnd();
  BackEnd(const BackEnd&) = delete;
  BackEnd& operator=(const BackEnd&) = delete;

  Renderer& renderer() { return *renderer_; }

 private:
  struct Context;
  std::unique_ptr<Context> context_;  // outlives the renderer
  std::unique_ptr<Renderer> renderer_;
};

}  // namespace stipple
