#pragma once

#include "render/hierarchy/cut.h"
#include "render/splat/renderer.h"
#include "tests/support/picture_errors.h"

namespace stipple {

/// A camera that comes nearer by the same factor in each frame.
struct ZoomPath {
  CameraAngles start;
  float lastZoom = 4;  ///< start.zoom is the first
  int frames = 120;
  int width = 320, height = 180;
};

/// How much more pictures change from frame to frame than those of the surface itself do.
struct Popping {
  double worst = 0;  ///< mean absolute difference of 8-bit values over the surface beyond that of the truth
  int worstFrame = 0;
  double worstTile = 0;      ///< the same of the worst square of 16 x 16 pixels
  double motion = 0;         ///< mean change of the truth from frame to frame
  int incompleteFrames = 0;  ///< cuts that did not reach their tau
  int holes = 0;             ///< of all frames
};

/// Draws the path with one CutMemory, as a viewer does, and compares with rays cast at `truth`, 2 x 2 a
/// pixel.
Popping measurePopping(Renderer& renderer, const Hierarchy& hierarchy, const scenes::RaySurface& truth,
                       const ZoomPath& path, const CutOptions& options);

}  // namespace stipple
