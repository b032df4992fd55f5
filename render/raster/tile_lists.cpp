#include "render/raster/tile_lists.h"

#include <algorithm>
#include <utility>

#include "core/parallel.h"

namespace stipple {

namespace {

// Splats that one thread counts; few enough blocks that their counts stay small.
constexpr std::size_t kLeastBlock = 1 << 14, kMostBlocks = 64;

}  // namespace

void listTiles(std::span<const SplatReach> reach, int width, int height, int size, TileLists& lists,
               const Progress* progress) {
  lists.columns = (width + size - 1) / size;
  lists.rows = (height + size - 1) / size;
  const std::size_t tiles = static_cast<std::size_t>(lists.columns) * lists.rows;
  const std::size_t blocks = std::clamp<std::size_t>(reach.size() / kLeastBlock, 1, kMostBlocks);
  const std::size_t block = std::max<std::size_t>((reach.size() + blocks - 1) / blocks, 1);
  std::vector<std::uint32_t> counts(blocks * tiles, 0);
  parallelFor(
      reach.size(), block,
      [&](std::size_t begin, std::size_t end) {
        std::uint32_t* count = counts.data() + begin / block * tiles;
        for (std::size_t i = begin; i < end; ++i) {
          forTilesOf(reach[i].box, size, lists.columns, [&](int tile) { ++count[tile]; });
        }
      },
      progress);
  lists.offsets.resize(tiles + 1);
  std::uint32_t sum = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    lists.offsets[tile] = sum;
    for (std::size_t b = 0; b < blocks; ++b) sum += std::exchange(counts[b * tiles + tile], sum);
  }
  lists.offsets[tiles] = sum;
  if (lists.splats.size() < sum) lists.splats.resize(sum + sum / 4);
  parallelFor(
      reach.size(), block,
      [&](std::size_t begin, std::size_t end) {
        std::uint32_t* place = counts.data() + begin / block * tiles;
        for (std::size_t i = begin; i < end; ++i) {
          forTilesOf(reach[i].box, size, lists.columns,
                     [&](int tile) { lists.splats[place[tile]++] = static_cast<std::uint32_t>(i); });
        }
      },
      progress);
}

}  // namespace stipple
