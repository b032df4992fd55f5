#include "app/panels/imgui_raster.h"

#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>

#include "app/panels/triangle.h"

namespace stipple {

namespace {

// What all draw lists of a drawing share.
struct Placement {
  ImVec2 origin, scale;  // of the display, and from its units to pixels
  float atlasWidth, atlasHeight;
  bool swapsRedAndBlue;
};

std::uint32_t withRedAndBlueSwapped(std::uint32_t color) {
  return (color & 0xff00ff00u) | ((color & 0xff) << 16) | ((color >> 16) & 0xff);
}

RasterVertex toPixels(const Placement& placement, const ImDrawVert& vertex) {
  return {.x = (vertex.pos.x - placement.origin.x) * placement.scale.x,
          .y = (vertex.pos.y - placement.origin.y) * placement.scale.y,
          .u = vertex.uv.x * placement.atlasWidth,
          .v = vertex.uv.y * placement.atlasHeight,
          .color = placement.swapsRedAndBlue ? withRedAndBlueSwapped(vertex.col) : vertex.col};
}

PixelRectangle intersection(const PixelRectangle& a, const PixelRectangle& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
          std::min(a.bottom, b.bottom)};
}

PixelRectangle unionOf(const PixelRectangle& a, const PixelRectangle& b) {
  if (a.isEmpty()) return b;
  if (b.isEmpty()) return a;
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

PixelRectangle boundsOf(std::span<const RasterVertex> vertices) {
  const auto [left, right] = std::ranges::minmax(vertices, {}, &RasterVertex::x);
  const auto [top, bottom] = std::ranges::minmax(vertices, {}, &RasterVertex::y);
  return {firstPixelFrom(left.x), firstPixelFrom(top.y), firstPixelFrom(right.x), firstPixelFrom(bottom.y)};
}

PixelRectangle scissorOf(const ImDrawCmd& command, const Placement& placement, const PixelTarget& target) {
  const auto x = [&](float value) {
    return firstPixelFrom((value - placement.origin.x) * placement.scale.x);
  };
  const auto y = [&](float value) {
    return firstPixelFrom((value - placement.origin.y) * placement.scale.y);
  };
  const ImVec4& clip = command.ClipRect;
  return intersection({x(clip.x), y(clip.y), x(clip.z), y(clip.w)}, {0, 0, target.width, target.height});
}

// Two triangles (a, b, c), (a, c, d).
bool isQuad(std::span<const ImDrawIdx> indices) {
  return indices.size() >= 6 && indices[0] == indices[3] && indices[2] == indices[4];
}

// One color, sides along the axes, the texture not turned: what text and unrounded boxes are made of.
bool isRectangle(const RasterVertex (&q)[4]) {
  const auto& [a, b, c, d] = q;
  return a.color == b.color && b.color == c.color && c.color == d.color && a.y == b.y && c.y == d.y &&
         a.x == d.x && b.x == c.x && a.x < b.x && a.y < d.y && a.u == d.u && b.u == c.u && a.v == b.v &&
         c.v == d.v;
}

// Returns the rectangle that holds what was drawn.
PixelRectangle drawCommand(RasterScene& scene, const Placement& placement, const ImDrawList& list,
                           const ImDrawCmd& command) {
  scene.scissor = scissorOf(command, placement, scene.target);
  if (scene.scissor.isEmpty() || command.ElemCount == 0) return {};
  std::span<const ImDrawIdx> indices(list.IdxBuffer.Data + command.IdxOffset, command.ElemCount);
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  const auto vertex = [&](std::size_t i) { return toPixels(placement, vertices[indices[i]]); };
  PixelRectangle bounds;
  while (indices.size() >= 3) {
    if (isQuad(indices)) {
      const RasterVertex corners[4] = {vertex(0), vertex(1), vertex(2), vertex(5)};
      if (isRectangle(corners)) {
        bounds = unionOf(bounds, boundsOf(corners));
        drawRectangle(scene, corners[0], corners[2]);
        indices = indices.subspan(6);
        continue;
      }
    }
    const RasterVertex corners[3] = {vertex(0), vertex(1), vertex(2)};
    indices = indices.subspan(3);
    // Many triangles of soft edges hold no center of a pixel.
    const PixelRectangle box = intersection(boundsOf(corners), scene.scissor);
    if (box.isEmpty()) continue;
    bounds = unionOf(bounds, box);
    drawTriangle(scene, corners);
  }
  return intersection(bounds, scene.scissor);
}

// Joins `added` with all that it overlaps, so that the rectangles stay disjoint.
void join(std::vector<PixelRectangle>& rectangles, PixelRectangle added) {
  if (added.isEmpty()) return;
  for (bool grew = true; grew;) {
    grew = std::erase_if(rectangles, [&](const PixelRectangle& other) {
             if (intersection(other, added).isEmpty()) return false;
             added = unionOf(other, added);
             return true;
           }) > 0;
  }
  rectangles.push_back(added);
}

// Multiplying and shifting mixes eight bytes at a time; the last ones are padded with zeros.
class Fingerprint {
 public:
  void add(const void* bytes, std::size_t count) {
    const auto* next = static_cast<const char*>(bytes);
    for (; count > 0;) {
      std::uint64_t word = 0;
      const std::size_t part = std::min(count, sizeof(word));
      std::memcpy(&word, next, part);
      value_ = (value_ ^ word) * 0x9E3779B97F4A7C15u;
      value_ ^= value_ >> 29;
      next += part, count -= part;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0x243F6A8885A308D3u;
};

}  // namespace

std::vector<PixelRectangle> rasterize(const ImDrawData& drawing, const AlphaTexture& atlas,
                                      const PixelTarget& target) {
  assert(target.height == 0 || target.pixels.size() >= (target.height - 1) * target.stride + target.width);
  assert(atlas.width > 0 && atlas.height > 0);
  const Placement placement{.origin = drawing.DisplayPos,
                            .scale = drawing.FramebufferScale,
                            .atlasWidth = float(atlas.width),
                            .atlasHeight = float(atlas.height),
                            .swapsRedAndBlue = target.order == ChannelOrder::kBgra};
  RasterScene scene{.target = target, .atlas = atlas, .scissor = {}};
  std::vector<PixelRectangle> touched;
  for (const ImDrawList* list : std::span(drawing.CmdLists, drawing.CmdListsCount)) {
    for (const ImDrawCmd& command : list->CmdBuffer) {
      if (command.UserCallback == nullptr) join(touched, drawCommand(scene, placement, *list, command));
    }
  }
  return touched;
}

std::uint64_t fingerprintOf(const ImDrawData& drawing) {
  Fingerprint fingerprint;
  fingerprint.add(&drawing.DisplaySize, sizeof(drawing.DisplaySize));
  fingerprint.add(&drawing.FramebufferScale, sizeof(drawing.FramebufferScale));
  for (const ImDrawList* list : std::span(drawing.CmdLists, drawing.CmdListsCount)) {
    fingerprint.add(list->VtxBuffer.Data, list->VtxBuffer.size_in_bytes());
    fingerprint.add(list->IdxBuffer.Data, list->IdxBuffer.size_in_bytes());
    for (const ImDrawCmd& command : list->CmdBuffer) {
      fingerprint.add(&command.ClipRect, sizeof(command.ClipRect));
      fingerprint.add(&command.ElemCount, sizeof(command.ElemCount));
    }
  }
  return fingerprint.value();
}

}  // namespace stipple
