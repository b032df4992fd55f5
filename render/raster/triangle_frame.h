#pragma once

#include "core/progress.h"
#include "render/appearance/appearance.h"
#include "render/raster/frame.h"
#include "render/raster/triangles.h"

namespace stipple {

/// Draws triangles in the light and the style of splats. `layer` keeps its memory from frame to frame. Throws
/// Cancelled with the frame half drawn.
void drawTriangles(const SurfaceMesh& mesh, const View& view, const Appearance& appearance, MeshLayer& layer,
                   FrameBuffers& frame, const Progress* progress);

}  // namespace stipple
