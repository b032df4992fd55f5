#include "render/splat/cpu_renderer.h"

#include <cmath>
#include <utility>

namespace stipple {

// Splats are read where they are.
void CpuRenderer::upload(const Hierarchy&, const std::vector<NodeRange>&) {}

void CpuRenderer::draw(const Hierarchy& hierarchy, const std::vector<Index>& nodes, const View& view,
                       const Appearance& appearance, Accumulate accumulate, const Progress* progress) {
  raster_.draw(hierarchy.splats(), nodes, view, appearance, drawn_, progress);
  show(view, appearance, accumulate);
}

void CpuRenderer::redraw(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) {
  frames_ = 1;
  if (raster_.redraw(hierarchy.splats(), changed, shown_)) return;
  const std::vector<Index> nodes(raster_.nodes().begin(), raster_.nodes().end());
  draw(hierarchy, nodes, view_, appearance_, Accumulate::kStartAnew, nullptr);
}

// The frame that was drawn is complete: it becomes the picture, or part of the mean.
void CpuRenderer::show(const View& view, const Appearance& appearance, Accumulate accumulate) {
  view_ = view;
  appearance_ = appearance;
  const bool adds = accumulate == Accumulate::kAddToMean && frames_ > 0 && shown_.width == drawn_.width &&
                    shown_.height == drawn_.height;
  frames_ = adds ? frames_ + 1 : 1;
  if (adds) {
    const float share = 1 / static_cast<float>(frames_);
    parallelFor(drawn_.light.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        drawn_.light[i] = shown_.light[i] + share * (drawn_.light[i] - shown_.light[i]);
    });
  }
  std::swap(drawn_, shown_);
}

void CpuRenderer::drawMesh(const SurfaceMesh& mesh, const View& view, const Appearance& appearance,
                           Accumulate accumulate, const Progress* progress) {
  drawTriangles(mesh, view, appearance, triangles_, drawn_, progress);
  show(view, appearance, accumulate);
}

Image CpuRenderer::image() {
  return encode(shown_, appearance_.background);
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
