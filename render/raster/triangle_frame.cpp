#include "render/raster/triangle_frame.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/appearance/kernel.h"
#include "render/appearance/light.h"
#include "render/raster/finish.h"

namespace stipple {

namespace {

constexpr std::size_t kRows = 16;

class TriangleShader {
 public:
  TriangleShader(const View& view, const Appearance& appearance) : view_(view), appearance_(appearance) {
    const auto& linear = linearTable();
    const Rgba8& color = appearance.selectionColor;
    selection_ = {linear[color.r], linear[color.g], linear[color.b]};
  }

  glm::vec3 shade(const MeshLayer& layer, std::size_t pixel, const glm::vec2& px) const {
    const glm::vec3 albedo =
        glm::mix(layer.colors[pixel], selection_, kernel::kSelectionShare * layer.selected[pixel]);
    if (!appearance_.lit) return albedo;
    glm::vec3 normal = layer.normals[pixel];
    const glm::vec3 ray = view_.isPerspective() ? view_.fromPixels(px, 1) : glm::vec3(0, 0, 1);
    if (appearance_.twoSided && glm::dot(normal, ray) > 0) normal = -normal;
    return albedo * light::shade(normal);
  }

 private:
  const View& view_;
  const Appearance& appearance_;
  glm::vec3 selection_;
};

}  // namespace

void drawTriangles(const SurfaceMesh& mesh, const View& view, const Appearance& appearance, MeshLayer& layer,
                   FrameBuffers& frame, const Progress* progress) {
  rasterizeTriangles(mesh, view, layer, progress);
  frame.resize(view.width, view.height);
  const TriangleShader shader(view, appearance);
  parallelFor(frame.height, kRows, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const std::size_t pixel = frame.at(x, y);
        frame.depth[pixel] = layer.depth[pixel];
        frame.nodes[pixel] = FrameBuffers::kNoNode;
        const bool isSeen = layer.triangles[pixel] != MeshLayer::kNone;
        const glm::vec2 px(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        frame.light[pixel] = isSeen ? glm::vec4(shader.shade(layer, pixel, px), 1) : glm::vec4(0);
      }
    }
  });
  Finisher finisher;
  finisher.takeDepth(frame, view, progress);
  parallelFor(frame.height, kRows, [&](std::size_t begin, std::size_t end) {
    finisher.finish(frame, view, appearance,
                    {0, static_cast<int>(begin), frame.width, static_cast<int>(end)});
  });
}

}  // namespace stipple
