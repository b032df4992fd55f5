#pragma once

#include <span>
#include <vector>

#include "core/progress.h"
#include "render/appearance/appearance.h"
#include "render/hierarchy/refit.h"
#include "render/raster/finish.h"
#include "render/raster/frame.h"
#include "render/raster/tile_lists.h"

namespace stipple {

/// Draws splats on the processor: lists them by tile, draws tile by tile in the cache (projection,
/// visibility, attributes, light), then finishes with what needs neighbors. Parallel; same bits for any
/// number of threads.
class Raster {
 public:
  /// Draws nodes into `frame`, which keeps its memory. Throws Cancelled with the frame half drawn.
  void draw(std::span<const Splat> splats, std::span<const Index> nodes, const View& view,
            const Appearance& appearance, FrameBuffers& frame, const Progress* progress);

  /// After draw() of the same nodes: draws only the tiles again that changed colors touch. False, with
  /// nothing done, where anything but colors changed.
  bool redraw(std::span<const Splat> splats, std::span<const NodeRange> changed, FrameBuffers& frame);

  /// Of the last draw().
  std::span<const Index> nodes() const { return nodes_; }

 private:
  void takeSplats(std::span<const Splat> splats, std::size_t begin, std::size_t end);
  void drawTiles(std::span<const std::uint32_t> tiles, FrameBuffers& frame, const Progress* progress);
  PixelRect rectOf(std::uint32_t tile, const FrameBuffers& frame) const;
  std::vector<std::uint32_t> findDrawn(std::span<const NodeRange> changed) const;

  std::vector<Index> nodes_;
  View view_;
  Appearance appearance_;
  std::vector<Splat> splats_;  // of the nodes, as they were drawn
  std::vector<SplatReach> reach_;
  TileLists lists_;
  Finisher finisher_;
};

}  // namespace stipple
