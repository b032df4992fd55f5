#pragma once

#include <cstdint>
#include <span>

#include "render/appearance/appearance.h"
#include "render/hierarchy/hierarchy.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// Pixels [x0, x1] x [y0, y1].
struct PixelBox {
  std::int16_t x0 = 0, y0 = 0, x1 = -1, y1 = -1;
  bool isEmpty() const { return x1 < x0 || y1 < y0; }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// What is known of a splat before it is projected: the pixels that the ball about it may touch (none where
/// it is not in the picture), and a depth that all of it lies behind.
struct SplatReach {
  PixelBox box;
  float nearest = 0;
};

/// A splat on the screen. At an offset (dx, dy) in pixels from its center a ray meets its plane at the place
/// (l0, l1) in units of the radius: with n_k = a_k dx + b_k dy and u = u0 + u1 dx + u2 dy, perspective: depth
/// z = 1 / u and l_k = n_k z; orthographic: z = u and l_k = n_k.
struct ProjectedSplat {
  float x = 0, y = 0;  // center, pixels
  float a0 = 0, b0 = 0, a1 = 0, b1 = 0;
  float u0 = 0, u1 = 0, u2 = 0;
  float perScreen = 0;                 // one over the squared radius of the screen-space kernel, 1 / pixels^2
  float z = 0, radius = 0;             // of the center, world units
  float nx = 0, ny = 0, nz = -1;       // unit, view space, towards the viewer
  float red = 0, green = 0, blue = 0;  // linear
  PixelBox box;                        // pixels it may touch; empty where it is not in the picture
};

/// `reach` has the length of `splats`. `screenRadiusPx`: of the largest screen-space kernel.
void findReach(std::span<const Splat> splats, const View& view, float screenRadiusPx,
               std::span<SplatReach> reach);

/// Projects the splats at these places; `projected` has the length of `places`.
void projectSplats(std::span<const Splat> splats, std::span<const std::uint32_t> places, const View& view,
                   const Appearance& appearance, std::span<ProjectedSplat> projected);

}  // namespace stipple
