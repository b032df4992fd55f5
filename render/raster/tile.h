#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/raster/frame.h"
#include "render/raster/projected_splat.h"

namespace stipple {

/// A square of the picture that is drawn at once in the cache.
struct Tile {
  static constexpr int kSize = 32;
  static constexpr int kPadding = 8;  // a vector may reach over the right edge
  static constexpr int kStride = kSize + kPadding;
  static constexpr int kPixels = kStride * kSize;
  using Plane = std::array<float, kPixels>;

  int x = 0, y = 0, width = 0, height = 0;  // pixels of the picture

  alignas(64) Plane depth;
  alignas(64) std::array<std::int32_t, kPixels> splat;  // place among `splats`, -1: none
  alignas(64) std::array<Plane, 3> seen;                // normal of the visible splat
  alignas(64) std::array<Plane, 8> sums;                // red, green, blue, normal x, y, z, weight, depth
  std::vector<ProjectedSplat> splats;  // those not known to be hidden, in the order of the list
  std::vector<std::uint32_t> places;   // of these in what is drawn
};

/// What is drawn. `splats`, `reach` and `nodes` have one length.
struct DrawnSplats {
  std::span<const Splat> splats;
  std::span<const SplatReach> reach;
  std::span<const Index> nodes;
  const View& view;
  const Appearance& appearance;
};

/// Draws the listed splats into a tile and shades it into the frame. A splat is projected where it first may
/// be seen: what is known to be hidden costs no more than its reach.
void drawTile(Tile& tile, const DrawnSplats& drawn, std::span<const std::uint32_t> list, FrameBuffers& frame);

/// The instruction set that was chosen for this machine, as Highway names it.
const char* rasterInstructionSet();

}  // namespace stipple
