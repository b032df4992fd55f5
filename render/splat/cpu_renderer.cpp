#include "render/splat/cpu_renderer.h"

#include <cmath>
#include <utility>

namespace stipple {

// Splats are read where they are.
void CpuRenderer::upload(const Hierarchy&, const std::vector<NodeRange>&) {}

void CpuRenderer::draw(const Hierarchy& hierarchy, const std::vector<Index>& nodes, const View& view,
                       const Appearance& appearance, Accumulate accumulate, const Progress* progress) {
  raster_.draw(hierarchy.splats(), nodes, view, appearance, drawn_, progress);
  take(drawn_, view, appearance, accumulate);
}

void CpuRenderer::take(FrameBuffers& frame, const View& view, const Appearance& appearance,
                       Accumulate accumulate) {
  view_ = view;
  background_ = appearance.background;
  const bool adds = accumulate == Accumulate::kAddToMean && frames_ > 0 && shown_.width == frame.width &&
                    shown_.height == frame.height;
  frames_ = adds ? frames_ + 1 : 1;
  if (adds) {
    const float share = 1 / static_cast<float>(frames_);
    parallelFor(frame.light.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        frame.light[i] = shown_.light[i] + share * (frame.light[i] - shown_.light[i]);
    });
  }
  std::swap(drawn_, shown_);
}

void CpuRenderer::drawMesh(const SurfaceMesh&, const View&, const Appearance&, Accumulate, const Progress*) {
  throw InvalidInput("triangles cannot be drawn by this back end");
}

Image CpuRenderer::image() {
  return encode(shown_, background_);
}

std::optional<Pick> CpuRenderer::pick(int x, int y) {
  if (x < 0 || y < 0 || x >= shown_.width || y >= shown_.height) return {};
  const std::size_t at = shown_.at(x, y);
  if (shown_.nodes[at] == FrameBuffers::kNoNode) return {};
  const glm::vec2 px(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  const float depth = shown_.depth[at];
  return Pick{shown_.nodes[at], depth, view_.toWorld(view_.fromPixels(px, depth))};
}

}  // namespace stipple
