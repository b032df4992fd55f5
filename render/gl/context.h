#pragma once

#include <optional>
#include <string>

namespace stipple::gl {

/// What the OpenGL context that is current in this thread offers.
struct Context {
  int version = 0;       ///< 45: OpenGL 4.5
  std::string renderer;  ///< the driver's name of the graphics card

  /// Drawn by the processor: llvmpipe, softpipe, swrast.
  bool isSoftware() const;
};

/// Nothing where no context of desktop OpenGL is current.
std::optional<Context> currentContext();

}  // namespace stipple::gl
