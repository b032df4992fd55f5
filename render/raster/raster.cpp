#include "render/raster/raster.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "render/appearance/kernel.h"
#include "render/raster/tile.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 1 << 12;
constexpr int kTilesAtOnce = 4;

bool hasSameShape(const Splat& a, const Splat& b) {
  return a.center() == b.center() && a.radius == b.radius && a.shape == b.shape;
}

}  // namespace

void Raster::draw(std::span<const Splat> splats, std::span<const Index> nodes, const View& view,
                  const Appearance& appearance, FrameBuffers& frame, const Progress* progress) {
  view_ = view;
  appearance_ = appearance;
  nodes_.assign(nodes.begin(), nodes.end());
  if (splats_.size() < nodes.size()) {
    splats_.resize(nodes.size() + nodes.size() / 4);
    reach_.resize(splats_.size());
  }
  frame.resize(view.width, view.height);
  parallelFor(
      nodes.size(), kGrain, [&](std::size_t begin, std::size_t end) { takeSplats(splats, begin, end); },
      progress);
  listTiles(std::span(reach_).first(nodes.size()), view.width, view.height, Tile::kSize, lists_, progress);
  std::vector<std::uint32_t> tiles(static_cast<std::size_t>(lists_.columns) * lists_.rows);
  std::iota(tiles.begin(), tiles.end(), 0u);
  drawTiles(tiles, frame, progress);
  if (appearance.edgeStrength > 0) finisher_.takeDepth(frame, view_, progress);
  parallelFor(
      frame.height, Tile::kSize,
      [&](std::size_t begin, std::size_t end) {
        finisher_.finish(frame, view_, appearance_,
                         {0, static_cast<int>(begin), frame.width, static_cast<int>(end)});
      },
      progress);
}

// Splats lie where the hierarchy has them, several levels apart: they are asked for before it is their turn.
void Raster::takeSplats(std::span<const Splat> splats, std::size_t begin, std::size_t end) {
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = begin; i < end; ++i) {
    if (i + kAhead < end) __builtin_prefetch(&splats[nodes_[i + kAhead]]);
    splats_[i] = splats[nodes_[i]];
  }
  findReach(std::span(splats_).subspan(begin, end - begin), view_,
            kernel::screenKernelOf(appearance_.isOneOfMany).radiusPx,
            std::span(reach_).subspan(begin, end - begin));
}

void Raster::drawTiles(std::span<const std::uint32_t> tiles, FrameBuffers& frame, const Progress* progress) {
  const DrawnSplats drawn{splats_, reach_, nodes_, view_, appearance_};
  parallelFor(
      tiles.size(), kTilesAtOnce,
      [&](std::size_t begin, std::size_t end) {
        const auto tile = std::make_unique_for_overwrite<Tile>();
        for (const std::uint32_t at : tiles.subspan(begin, end - begin)) {
          const PixelRect rect = rectOf(at, frame);
          tile->x = rect.x0;
          tile->y = rect.y0;
          tile->width = rect.x1 - rect.x0;
          tile->height = rect.y1 - rect.y0;
          drawTile(*tile, drawn, lists_.of(at), frame);
        }
      },
      progress);
}

PixelRect Raster::rectOf(std::uint32_t tile, const FrameBuffers& frame) const {
  const int x = static_cast<int>(tile) % lists_.columns * Tile::kSize;
  const int y = static_cast<int>(tile) / lists_.columns * Tile::kSize;
  return {x, y, std::min(x + Tile::kSize, frame.width), std::min(y + Tile::kSize, frame.height)};
}

// Places in the list of drawn nodes of those in the ranges, ascending.
std::vector<std::uint32_t> Raster::findDrawn(std::span<const NodeRange> changed) const {
  constexpr int kBlock = 10;  // log2 of the nodes that one flag stands for
  std::vector<std::uint8_t> isTouched;
  for (const NodeRange& range : changed) {
    if (range.begin >= range.end) continue;
    const std::size_t last = (range.end - 1) >> kBlock;
    if (isTouched.size() <= last) isTouched.resize(last + 1, 0);
    std::fill(isTouched.begin() + (range.begin >> kBlock),
              isTouched.begin() + static_cast<std::ptrdiff_t>(last) + 1, 1);
  }
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Index node = nodes_[i];
    if (node >> kBlock >= isTouched.size() || !isTouched[node >> kBlock]) continue;
    const auto after = std::upper_bound(changed.begin(), changed.end(), node,
                                        [](Index n, const NodeRange& range) { return n < range.begin; });
    if (after != changed.begin() && node < std::prev(after)->end)
      places.push_back(static_cast<std::uint32_t>(i));
  }
  return places;
}

bool Raster::redraw(std::span<const Splat> splats, std::span<const NodeRange> changed, FrameBuffers& frame) {
  if (frame.width != view_.width || frame.height != view_.height) return false;
  const std::vector<std::uint32_t> places = findDrawn(changed);
  for (const std::uint32_t place : places) {
    if (!hasSameShape(splats[nodes_[place]], splats_[place])) return false;
  }
  std::vector<std::uint8_t> isDirty(static_cast<std::size_t>(lists_.columns) * lists_.rows, 0);
  for (const std::uint32_t place : places) {
    splats_[place].color = splats[nodes_[place]].color;
    forTilesOf(reach_[place].box, Tile::kSize, lists_.columns, [&](int tile) { isDirty[tile] = 1; });
  }
  std::vector<std::uint32_t> tiles;
  for (std::uint32_t tile = 0; tile < isDirty.size(); ++tile) {
    if (isDirty[tile]) tiles.push_back(tile);
  }
  drawTiles(tiles, frame, nullptr);
  parallelFor(tiles.size(), kTilesAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      finisher_.finish(frame, view_, appearance_, rectOf(tiles[i], frame));
  });
  return true;
}

}  // namespace stipple
