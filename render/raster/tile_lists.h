#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/progress.h"
#include "render/raster/projected_splat.h"

namespace stipple {

/// For every tile of a picture the splats that may touch it, in their order. Compressed rows.
struct TileLists {
  int columns = 0, rows = 0;
  std::vector<std::uint32_t> offsets, splats;

  std::span<const std::uint32_t> of(std::size_t tile) const {
    return {splats.data() + offsets[tile], offsets[tile + 1] - offsets[tile]};
  }
};

/// body(tile) for every tile that a box touches.
template <class Body>
void forTilesOf(const PixelBox& box, int size, int columns, const Body& body) {
  if (box.isEmpty()) return;
  for (int row = box.y0 / size; row <= box.y1 / size; ++row) {
    for (int column = box.x0 / size; column <= box.x1 / size; ++column) body(row * columns + column);
  }
}

/// Counting sort of the splats by tiles of `size` pixels; `lists` keeps its memory from frame to frame.
void listTiles(std::span<const SplatReach> reach, int width, int height, int size, TileLists& lists,
               const Progress* progress);

}  // namespace stipple
