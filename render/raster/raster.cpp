#include "render/raster/raster.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "render/raster/tile.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 1 << 12;
constexpr int kTilesAtOnce = 4;

}  // namespace

void Raster::draw(std::span<const Splat> splats, std::span<const Index> nodes, const View& view,
                  const Appearance& appearance, FrameBuffers& frame, const Progress* progress) {
  view_ = view;
  appearance_ = appearance;
  nodes_.assign(nodes.begin(), nodes.end());
  if (projected_.size() < nodes.size()) {
    projected_.resize(nodes.size() + nodes.size() / 4);
    boxes_.resize(projected_.size());
  }
  frame.resize(view.width, view.height);
  parallelFor(
      nodes.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        const std::size_t count = end - begin;
        projectSplats(splats, nodes.subspan(begin, count), view, appearance,
                      std::span(projected_).subspan(begin, count), std::span(boxes_).subspan(begin, count));
      },
      progress);
  listTiles(std::span(boxes_).first(nodes.size()), view.width, view.height, Tile::kSize, lists_, progress);
  std::vector<std::uint32_t> tiles(static_cast<std::size_t>(lists_.columns) * lists_.rows);
  std::iota(tiles.begin(), tiles.end(), 0u);
  drawTiles(tiles, frame, progress);
  finisher_.takeDepth(frame, view_, progress);
  parallelFor(
      frame.height, Tile::kSize,
      [&](std::size_t begin, std::size_t end) {
        finisher_.finish(frame, view_, appearance_,
                         {0, static_cast<int>(begin), frame.width, static_cast<int>(end)});
      },
      progress);
}

void Raster::drawTiles(std::span<const std::uint32_t> tiles, FrameBuffers& frame, const Progress* progress) {
  const TileOptions options = {.isPerspective = view_.isPerspective(),
                               .blends = appearance_.mode == SplatMode::kSplats,
                               .lit = appearance_.lit};
  parallelFor(
      tiles.size(), kTilesAtOnce,
      [&](std::size_t begin, std::size_t end) {
        const auto tile = std::make_unique_for_overwrite<Tile>();
        for (const std::uint32_t at : tiles.subspan(begin, end - begin)) {
          const PixelRect rect = rectOf(at, 0, frame);
          tile->x = rect.x0;
          tile->y = rect.y0;
          tile->width = rect.x1 - rect.x0;
          tile->height = rect.y1 - rect.y0;
          drawTile(*tile, projected_, boxes_, lists_.of(at), options, frame);
        }
      },
      progress);
}

PixelRect Raster::rectOf(std::uint32_t tile, int rim, const FrameBuffers& frame) const {
  const int x = static_cast<int>(tile) % lists_.columns * Tile::kSize;
  const int y = static_cast<int>(tile) / lists_.columns * Tile::kSize;
  return {std::max(x - rim, 0), std::max(y - rim, 0), std::min(x + Tile::kSize + rim, frame.width),
          std::min(y + Tile::kSize + rim, frame.height)};
}

}  // namespace stipple
