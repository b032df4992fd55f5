#pragma once

#include "render/gl/context.h"

namespace stipple::gl {

/// An OpenGL 4.5 core context without a window, made current in the thread that creates it, where it must end
/// as well.
class EglContext {
 public:
  /// Throws IoError, saying in one sentence what is missing, where the system has no such context.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  const std::string& renderer() const { return context_.renderer; }
  bool isSoftware() const { return context_.isSoftware(); }

 private:
  void* display_ = nullptr;
  void* handle_ = nullptr;
  Context context_;
};

}  // namespace stipple::gl
