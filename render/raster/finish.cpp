#include "render/raster/finish.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/progress.h"
#include "render/appearance/kernel.h"
#include "render/appearance/light.h"
#include "render/raster/edge_factors.h"

namespace stipple {

namespace {

constexpr std::size_t kRows = 16;

void drawRing(FrameBuffers& frame, const View& view, const BrushRing& ring, int y, const PixelRect& rect) {
  const std::array<float, 256>& linear = linearTable();
  const glm::vec3 color(linear[ring.color.r], linear[ring.color.g], linear[ring.color.b]);
  const glm::vec3 center = view.toView(ring.center);
  for (int x = rect.x0; x < rect.x1; ++x) {
    const std::size_t at = frame.at(x, y);
    const float depth = frame.depth[at];
    if (!std::isfinite(depth)) continue;
    const glm::vec2 px(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const float distance = glm::length(view.fromPixels(px, depth) - center);
    const float off = (distance - ring.radius) * view.pixelsPerUnit(depth);  // pixels
    const float line = std::clamp(0.5f * kernel::kRingPx + 0.5f - std::abs(off), 0.f, 1.f);
    const float share = std::max(line, off < 0 ? kernel::kRingFill : 0.f);
    glm::vec4& light = frame.light[at];
    for (int k = 0; k < 3; ++k) light[k] += share * (color[k] - light[k]);
  }
}

}  // namespace

void Finisher::takeDepth(const FrameBuffers& frame, const View& view, const Progress* progress) {
  stride_ = frame.width + 2 * kReach + kEdgePadding;
  depth_.assign(static_cast<std::size_t>(stride_) * (frame.height + 2 * kReach), FrameBuffers::kEmpty);
  // One picture height away darkens as much in both projections and at any size of the picture.
  const bool perspective = view.isPerspective();
  const float scale = perspective ? 1 : view.focalPx / static_cast<float>(frame.height);
  strength_ = static_cast<float>(frame.height);
  parallelFor(
      frame.height, kRows,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          float* to = depth_.data() + (y + kReach) * stride_ + kReach;
          scaleDepths(frame.depth.data() + y * frame.width, frame.width, perspective, scale, to);
        }
      },
      progress);
}

void Finisher::finish(FrameBuffers& frame, const View& view, const Appearance& appearance,
                      const PixelRect& rect) const {
  for (int y = rect.y0; y < rect.y1; ++y) {
    if (appearance.edgeStrength > 0) finishRow(frame, appearance, y, rect);
    if (appearance.brush) drawRing(frame, view, *appearance.brush, y, rect);
  }
}

void Finisher::finishRow(FrameBuffers& frame, const Appearance& appearance, int y,
                         const PixelRect& rect) const {
  const float* row = depth_.data() + static_cast<std::size_t>(y + kReach) * stride_ + kReach;
  static thread_local std::vector<float> factors;
  factors.resize(static_cast<std::size_t>(rect.x1 - rect.x0) + kEdgePadding);
  edgeFactors(row + rect.x0, stride_, rect.x1 - rect.x0,
              kernel::kEdgeStrength * strength_ * appearance.edgeStrength, factors.data());
  for (int x = rect.x0; x < rect.x1; ++x) {
    glm::vec4& light = frame.light[frame.at(x, y)];
    const float factor = factors[x - rect.x0];
    light.r *= factor;
    light.g *= factor;
    light.b *= factor;
  }
}

Image encode(const FrameBuffers& frame, const std::optional<Rgba8>& background) {
  Image image{frame.width, frame.height, std::vector<Rgba8>(frame.light.size())};
  const std::array<float, 256>& linear = linearTable();
  glm::vec3 behind(0);
  if (background) behind = {linear[background->r], linear[background->g], linear[background->b]};
  const Rgba8 empty =
      background ? Rgba8{background->r, background->g, background->b, 255} : Rgba8{0, 0, 0, 0};
  parallelFor(frame.light.size(), kRows * 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      glm::vec3 light(frame.light[i]);
      const float coverage = frame.light[i].a;
      if (coverage == 0) {
        image.pixels[i] = empty;
        continue;
      }
      std::uint8_t alpha = 255;
      if (background) {
        light += (1 - coverage) * behind;
      } else {
        alpha = static_cast<std::uint8_t>(coverage * 255 + 0.5f);
        light /= coverage;
      }
      image.pixels[i] = {encodeSrgb(light.r), encodeSrgb(light.g), encodeSrgb(light.b), alpha};
    }
  });
  return image;
}

}  // namespace stipple
