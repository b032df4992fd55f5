#include "render/raster/tile.h"

#include <algorithm>
#include <cmath>

#include "render/appearance/kernel.h"
#include "render/appearance/light.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/raster/tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stipple::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, Tile::kPadding>;
using Ints = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;

// The part of a splat's pixels that lies in a tile, relative to the tile.
struct Part {
  int x0, y0, x1, y1;
};

HWY_INLINE Part partOf(const PixelBox& box, const Tile& tile) {
  return {std::max(box.x0 - tile.x, 0), std::max(box.y0 - tile.y, 0),
          std::min(box.x1 - tile.x, tile.width - 1), std::min(box.y1 - tile.y, tile.height - 1)};
}

// Footprint and depth of one splat along one row of pixels.
template <bool kPerspective>
struct Row {
  HWY_INLINE Row(const ProjectedSplat& splat, float dy)
      : s(splat), dy2(dy * dy), n0(splat.b0 * dy), n1(splat.b1 * dy), u(splat.u0 + splat.u2 * dy) {}

  struct Fragment {
    V q, z;
  };
  HWY_INLINE Fragment at(V dx) const {
    const Floats f;
    const V l0 = hn::MulAdd(hn::Set(f, s.a0), dx, hn::Set(f, n0));
    const V l1 = hn::MulAdd(hn::Set(f, s.a1), dx, hn::Set(f, n1));
    const V depth = hn::MulAdd(hn::Set(f, s.u1), dx, hn::Set(f, u));
    V q = hn::MulAdd(l0, l0, hn::Mul(l1, l1)), z = depth;
    if (kPerspective) {
      z = hn::Div(hn::Set(f, 1), depth);
      // Where the ray meets the plane behind the eye there is no disc.
      const M isBefore = hn::Gt(depth, hn::Zero(f));
      q = hn::IfThenElse(isBefore, hn::Mul(q, hn::Mul(z, z)), hn::Set(f, FrameBuffers::kEmpty));
      z = hn::IfThenElse(isBefore, z, hn::Set(f, s.z));
    }
    const V screen = hn::Mul(hn::MulAdd(dx, dx, hn::Set(f, dy2)), hn::Set(f, s.perScreen));
    z = hn::Min(hn::Max(z, hn::Set(f, s.z - s.radius)), hn::Set(f, s.z + s.radius));
    return {hn::Min(q, screen), z};
  }

  const ProjectedSplat& s;
  float dy2, n0, n1, u;
};

// body(row, place in the tile, dx, mask of the pixels that are the splat's) for all pixels of a splat in a
// tile.
template <bool kPerspective, class Body>
HWY_INLINE void forPixels(const Tile& tile, const ProjectedSplat& s, const Part& part, const Body& body) {
  const Floats f;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const float left = static_cast<float>(tile.x) + 0.5f - s.x, top = static_cast<float>(tile.y) + 0.5f - s.y;
  for (int y = part.y0; y <= part.y1; ++y) {
    const Row<kPerspective> row(s, top + static_cast<float>(y));
    for (int x = part.x0; x <= part.x1; x += lanes) {
      const V dx = hn::Iota(f, left + static_cast<float>(x));
      body(row, static_cast<std::size_t>(y) * Tile::kStride + x, dx,
           hn::FirstN(f, static_cast<std::size_t>(part.x1 - x + 1)));
    }
  }
}

template <bool kPerspective>
HWY_INLINE void findVisible(Tile& tile, const ProjectedSplat& s, const Part& part, std::int32_t id) {
  const Floats f;
  const Ints i;
  forPixels<kPerspective>(
      tile, s, part, [&](const Row<kPerspective>& row, std::size_t at, V dx, M inside) HWY_ATTR {
        const auto [q, z] = row.at(dx);
        const V held = hn::LoadU(f, tile.depth.data() + at);
        const M wins =
            hn::And(hn::And(inside, hn::Le(q, hn::Set(f, kernel::kVisibleShare))), hn::Lt(z, held));
        if (hn::AllFalse(f, wins)) return;
        hn::StoreU(hn::IfThenElse(wins, z, held), f, tile.depth.data() + at);
        const auto ids = hn::LoadU(i, tile.splat.data() + at);
        hn::StoreU(hn::IfThenElse(hn::RebindMask(i, wins), hn::Set(i, id), ids), i, tile.splat.data() + at);
      });
}

template <bool kPerspective>
HWY_INLINE void addAttributes(Tile& tile, const ProjectedSplat& s, const Part& part, std::int32_t id,
                              bool isOneOfMany) {
  const Floats f;
  const Ints i;
  const float values[6] = {s.red, s.green, s.blue, s.nx, s.ny, s.nz};
  forPixels<kPerspective>(
      tile, s, part, [&](const Row<kPerspective>& row, std::size_t at, V dx, M inside) HWY_ATTR {
        const auto [q, z] = row.at(dx);
        const V seen = hn::LoadU(f, tile.depth.data() + at);
        const M isFilled = hn::Lt(seen, hn::Set(f, FrameBuffers::kEmpty));  // something hides the background
        const M near = hn::And(isFilled, hn::Le(z, hn::Add(seen, hn::Set(f, kernel::kDepthBand * s.radius))));
        M counts = hn::And(hn::And(inside, hn::Le(q, hn::Set(f, 1))), near);
        if (hn::AllFalse(f, counts)) return;
        const V cosine =
            hn::MulAdd(hn::Set(f, s.nx), hn::LoadU(f, tile.seen[0].data() + at),
                       hn::MulAdd(hn::Set(f, s.ny), hn::LoadU(f, tile.seen[1].data() + at),
                                  hn::Mul(hn::Set(f, s.nz), hn::LoadU(f, tile.seen[2].data() + at))));
        const M isSeen = hn::RebindMask(f, hn::Eq(hn::LoadU(i, tile.splat.data() + at), hn::Set(i, id)));
        counts = hn::And(counts, hn::Or(isSeen, hn::Ge(cosine, hn::Set(f, kernel::kNormalCosine))));
        const V falloff = hn::Sub(hn::Set(f, 1), q);
        V share = hn::Mul(falloff, falloff);
        if (isOneOfMany) share = hn::Mul(share, share);
        const V weight = hn::IfThenElseZero(counts, hn::Max(share, hn::Set(f, kernel::kLeastWeight)));
        for (int k = 0; k < 6; ++k) {
          float* sum = tile.sums[k].data() + at;
          hn::StoreU(hn::MulAdd(weight, hn::Set(f, values[k]), hn::LoadU(f, sum)), f, sum);
        }
        float* sum = tile.sums[6].data() + at;
        hn::StoreU(hn::Add(weight, hn::LoadU(f, sum)), f, sum);
        sum = tile.sums[7].data() + at;
        hn::StoreU(hn::MulAdd(weight, z, hn::LoadU(f, sum)), f, sum);
      });
}

// Normals of the visible splats, which decide what is blended with them.
HWY_INLINE void gatherSeen(Tile& tile) {
  for (int y = 0; y < tile.height; ++y) {
    for (int at = y * Tile::kStride; at < y * Tile::kStride + tile.width; ++at) {
      if (tile.splat[at] < 0) continue;
      const ProjectedSplat& s = tile.splats[tile.splat[at]];
      tile.seen[0][at] = s.nx;
      tile.seen[1][at] = s.ny;
      tile.seen[2][at] = s.nz;
    }
  }
}

// Without blending the visible splat is all there is.
HWY_INLINE void takeVisible(Tile& tile) {
  for (int y = 0; y < tile.height; ++y) {
    for (int at = y * Tile::kStride; at < y * Tile::kStride + tile.width; ++at) {
      if (tile.splat[at] < 0) continue;
      const ProjectedSplat& s = tile.splats[tile.splat[at]];
      const float values[8] = {s.red, s.green, s.blue, s.nx, s.ny, s.nz, 1, tile.depth[at]};
      for (int k = 0; k < 8; ++k) tile.sums[k][at] = values[k];
    }
  }
}

// Means of what was added up, lit; interleaved into the frame.
HWY_INLINE void shadeRow(const Tile& tile, int y, bool lit, FrameBuffers& frame) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  HWY_ALIGN float rgb[4][Tile::kStride];
  for (std::size_t x = 0; x < static_cast<std::size_t>(tile.width); x += lanes) {
    const std::size_t at = static_cast<std::size_t>(y) * Tile::kStride + x;
    const auto sum = [&](int k) HWY_ATTR { return hn::LoadU(f, tile.sums[k].data() + at); };
    const V weight = sum(6);
    const M isCovered = hn::Gt(weight, hn::Zero(f));
    const V scale = hn::Div(hn::Set(f, 1), hn::IfThenElse(isCovered, weight, hn::Set(f, 1)));
    V shade = hn::Set(f, 1);
    if (lit) {
      const V nx = sum(3), ny = sum(4), nz = sum(5);
      const V length = hn::Sqrt(hn::MulAdd(nx, nx, hn::MulAdd(ny, ny, hn::Mul(nz, nz))));
      const V along =
          hn::MulAdd(nx, hn::Set(f, light::kKey.x),
                     hn::MulAdd(ny, hn::Set(f, light::kKey.y), hn::Mul(nz, hn::Set(f, light::kKey.z))));
      const V perLength = hn::Div(hn::Set(f, 1), hn::Max(length, hn::Set(f, 1e-12f)));
      const V key = hn::Max(hn::Zero(f), hn::Mul(along, perLength));
      const V head = hn::Max(hn::Zero(f), hn::Neg(hn::Mul(nz, perLength)));
      shade = hn::MulAdd(hn::Set(f, light::kDiffuse), key, hn::Set(f, light::kAmbient));
      shade = hn::MulAdd(hn::Set(f, light::kHead), head, shade);
    }
    shade = hn::Mul(shade, scale);
    for (int k = 0; k < 3; ++k) hn::Store(hn::Mul(shade, sum(k)), f, rgb[k] + x);
    hn::Store(hn::IfThenElseZero(isCovered, hn::Set(f, 1)), f, rgb[3] + x);
  }
  glm::vec4* out = frame.light.data() + frame.at(tile.x, tile.y + y);
  for (int x = 0; x < tile.width; ++x) out[x] = {rgb[0][x], rgb[1][x], rgb[2][x], rgb[3][x]};
}

HWY_INLINE void storeTile(const Tile& tile, const DrawnSplats& drawn, FrameBuffers& frame) {
  for (int y = 0; y < tile.height; ++y) {
    const std::size_t from = static_cast<std::size_t>(y) * Tile::kStride, to = frame.at(tile.x, tile.y + y);
    for (int x = 0; x < tile.width; ++x) {
      const std::int32_t splat = tile.splat[from + x];
      // The mean depth is smooth where discs meet at an angle.
      frame.depth[to + x] =
          splat < 0 ? FrameBuffers::kEmpty : tile.sums[7][from + x] / tile.sums[6][from + x];
      frame.nodes[to + x] = splat < 0 ? FrameBuffers::kNoNode : drawn.nodes[tile.places[splat]];
    }
    shadeRow(tile, y, drawn.appearance.lit, frame);
  }
}

// Depth behind which nothing is seen in each cell of a tile; infinite where a pixel is still empty.
class Occluders {
 public:
  HWY_INLINE Occluders() {
    for (auto& row : farthest_) std::fill_n(row, kCells, FrameBuffers::kEmpty);
  }

  HWY_INLINE void look(const Tile& tile) {
    const Floats f;
    const std::size_t lanes = hn::Lanes(f);
    for (int row = 0; row * kCell < tile.height; ++row) {
      for (int column = 0; column * kCell < tile.width; ++column) {
        V farthest = hn::Zero(f);
        const std::size_t width = std::min(kCell, tile.width - column * kCell);
        for (int y = row * kCell; y < std::min((row + 1) * kCell, tile.height); ++y) {
          const float* depth = tile.depth.data() + y * Tile::kStride + column * kCell;
          for (std::size_t x = 0; x < width; x += lanes) {
            const V held = hn::IfThenElseZero(hn::FirstN(f, width - x), hn::LoadU(f, depth + x));
            farthest = hn::Max(farthest, held);
          }
        }
        farthest_[row][column] = hn::GetLane(hn::MaxOfLanes(f, farthest));
      }
    }
  }

  HWY_INLINE bool hide(const Part& part, float depth) const {
    for (int row = part.y0 / kCell; row <= part.y1 / kCell; ++row) {
      for (int column = part.x0 / kCell; column <= part.x1 / kCell; ++column) {
        if (depth <= farthest_[row][column]) return false;
      }
    }
    return true;
  }

 private:
  static constexpr int kCell = 8, kCells = Tile::kSize / kCell;
  float farthest_[kCells][kCells];
};

// Projects the splats of a part of a list that nothing hides so far; they follow those that the tile has.
HWY_INLINE void takeUnhidden(Tile& tile, const DrawnSplats& drawn, std::span<const std::uint32_t> list,
                             const Occluders& occluders) {
  for (const std::uint32_t place : list) {
    const SplatReach& reach = drawn.reach[place];
    if (occluders.hide(partOf(reach.box, tile), reach.nearest)) continue;
    __builtin_prefetch(&drawn.splats[place]);
    tile.places.push_back(place);
  }
  const std::size_t begin = tile.splats.size();
  tile.splats.resize(tile.places.size());
  projectSplats(drawn.splats, std::span(tile.places).subspan(begin), drawn.view, drawn.appearance,
                std::span(tile.splats).subspan(begin));
}

template <bool kPerspective>
HWY_INLINE void drawSplats(Tile& tile, const DrawnSplats& drawn, std::span<const std::uint32_t> list) {
  // Lists run roughly from front to back: what is hidden by all that came before is soon passed over.
  constexpr std::size_t kBetweenLooks = 64;
  const bool isOneOfMany = drawn.appearance.isOneOfMany;
  Occluders occluders;
  for (std::size_t begin = 0; begin < list.size(); begin += kBetweenLooks) {
    if (begin > 0) occluders.look(tile);
    std::size_t n = tile.splats.size();
    takeUnhidden(tile, drawn, list.subspan(begin, std::min(kBetweenLooks, list.size() - begin)), occluders);
    for (; n < tile.splats.size(); ++n) {
      const ProjectedSplat& s = tile.splats[n];
      findVisible<kPerspective>(tile, s, partOf(s.box, tile), static_cast<std::int32_t>(n));
    }
  }
  if (drawn.appearance.mode != SplatMode::kSplats) return takeVisible(tile);
  gatherSeen(tile);
  occluders.look(tile);
  for (std::size_t n = 0; n < tile.splats.size(); ++n) {
    const ProjectedSplat& s = tile.splats[n];
    const Part part = partOf(s.box, tile);
    if (occluders.hide(part, s.z - (1 + kernel::kDepthBand) * s.radius)) continue;
    addAttributes<kPerspective>(tile, s, part, static_cast<std::int32_t>(n), isOneOfMany);
  }
}

void drawOne(Tile& tile, const DrawnSplats& drawn, std::span<const std::uint32_t> list, FrameBuffers& frame) {
  tile.depth.fill(FrameBuffers::kEmpty);
  tile.splat.fill(-1);
  tile.splats.clear();
  tile.places.clear();
  if (!list.empty()) {
    for (Tile::Plane& plane : tile.sums) plane.fill(0);
    drawn.view.isPerspective() ? drawSplats<true>(tile, drawn, list) : drawSplats<false>(tile, drawn, list);
    return storeTile(tile, drawn, frame);
  }
  for (int y = 0; y < tile.height; ++y) {
    const std::size_t to = frame.at(tile.x, tile.y + y);
    std::fill_n(frame.light.data() + to, tile.width, glm::vec4(0));
    std::fill_n(frame.depth.data() + to, tile.width, FrameBuffers::kEmpty);
    std::fill_n(frame.nodes.data() + to, tile.width, FrameBuffers::kNoNode);
  }
}

const char* nameOfTarget() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace stipple::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stipple {

HWY_EXPORT(drawOne);
HWY_EXPORT(nameOfTarget);

void drawTile(Tile& tile, const DrawnSplats& drawn, std::span<const std::uint32_t> list,
              FrameBuffers& frame) {
  HWY_DYNAMIC_DISPATCH(drawOne)(tile, drawn, list, frame);
}

const char* rasterInstructionSet() {
  return HWY_DYNAMIC_DISPATCH(nameOfTarget)();
}

}  // namespace stipple
#endif
