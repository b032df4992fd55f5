#pragma once

#include <array>
#include <cstdint>
#include <span>

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
  alignas(64) std::array<std::int32_t, kPixels> splat;  // place in the list of projected splats, -1: none
  alignas(64) std::array<Plane, 3> seen;                // normal of the visible splat
  alignas(64) std::array<Plane, 8> sums;                // red, green, blue, normal x, y, z, weight, depth
};

struct TileOptions {
  bool isPerspective = true;
  bool blends = true;  ///< false: the nearest splat alone
  bool lit = true;
};

/// Draws splats into a tile and shades it into the frame.
void drawTile(Tile& tile, std::span<const ProjectedSplat> splats, std::span<const PixelBox> boxes,
              std::span<const std::uint32_t> list, const TileOptions& options, FrameBuffers& frame);

/// The instruction set that was chosen for this machine, as Highway names it.
const char* rasterInstructionSet();

}  // namespace stipple
