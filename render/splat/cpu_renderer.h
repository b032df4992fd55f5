#pragma once

#include "render/raster/raster.h"
#include "render/raster/triangle_frame.h"
#include "render/splat/renderer.h"

namespace stipple {

/// Draws on the processor, on all cores; needs no OpenGL.
class CpuRenderer final : public Renderer {
 public:
  const char* backend() const override { return "cpu"; }
  void upload(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) override;
  void draw(const Hierarchy& hierarchy, const std::vector<Index>& nodes, const View& view,
            const Appearance& appearance, Accumulate accumulate, const Progress* progress) override;
  void redraw(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) override;
  void drawMesh(const SurfaceMesh& mesh, const View& view, const Appearance& appearance,
                Accumulate accumulate, const Progress* progress) override;
  Image image() override;
  std::optional<Pick> pick(int x, int y) override;
  std::vector<float> depth() override { return shown_.depth; }

 private:
  void show(const View& view, const Appearance& appearance, Accumulate accumulate);

  Raster raster_;
  MeshLayer triangles_;
  FrameBuffers drawn_, shown_;  // shown: complete; its light is the mean
  int frames_ = 0;
  View view_;
  Appearance appearance_;
};

}  // namespace stipple
