#pragma once

#include <string>

#include "render/appearance/appearance.h"
#include "render/appearance/splat_colors.h"
#include "render/hierarchy/cut.h"
#include "render/splat/renderer.h"

namespace CLI {
class App;
}

namespace stipple {

/// What `render` and `turntable` have in common.
struct RenderOptions {
  std::string input, output;
  int width = 1280, height = 720;
  /// From the front, a little to its right and above: three sides of a thing are seen.
  CameraAngles camera{.yaw = 0.5235988f, .pitch = 0.3490659f};
  ColorSource colors;
  bool drawsTriangles = false;  ///< of the file, instead of splats
  Appearance appearance;        ///< with the mode of splats
  std::string glyphs;           ///< attribute; empty: none
  Backend backend = Backend::kAuto;
  float tau = 0;        ///< pixels; 0: what a frame for itself, or a mean of frames, needs
  int supersample = 0;  ///< N x N frames; 0: enough for a picture without steps
  bool json = false;
};

/// Adds IN and all options but -o to the command.
void addRenderOptions(CLI::App& command, RenderOptions& options);

}  // namespace stipple
