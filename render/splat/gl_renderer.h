#pragma once

#include <filesystem>

#include "render/gl/program.h"
#include "render/gl/shader_source.h"
#include "render/gl/vertex_array.h"
#include "render/splat/frame_targets.h"
#include "render/splat/renderer.h"
#include "render/splat/splat_store.h"

namespace stipple {

struct GlOptions {
  std::filesystem::path shaders = gl::shaderFolder();
  std::size_t chunkBytes = std::size_t{128} << 20;  ///< of the splats' buffers; some drivers allow no more
};

/// Draws with the OpenGL 4.5 context that is current in every call, destruction included. Leaves
/// framebuffers, viewport and clipping convention as they were, and no other state.
class GlRenderer final : public Renderer {
 public:
  /// Throws IoError where the context lacks something or a shader does not compile.
  explicit GlRenderer(const GlOptions& options = {});

  const char* backend() const override { return "gl"; }
  void upload(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) override;
  void draw(const Hierarchy& hierarchy, const std::vector<Index>& nodes, const View& view,
            const Appearance& appearance, Accumulate accumulate, const Progress* progress = nullptr) override;
  void redraw(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) override;
  void drawMesh(const SurfaceMesh& mesh, const View& view, const Appearance& appearance,
                Accumulate accumulate, const Progress* progress = nullptr) override;
  Image image() override;
  std::optional<Pick> pick(int x, int y) override;
  std::vector<float> depth() override;

  /// Copies the picture into the framebuffer that is bound for drawing, its lower left corner at that one's,
  /// without a round through main memory. The framebuffer has one sample a pixel.
  void present();

 private:
  void drawListed(const NodeList& list, const View& view, const Appearance& appearance, Accumulate accumulate,
                  const Progress* progress);
  void beginFrame(const View& view, const Appearance& appearance, bool isBlended);
  void drawSplats(gl::Program& program, const NodeList& list, const Progress* progress);
  void finishFrame(const View& view, const Appearance& appearance, Accumulate accumulate);
  void encode();

  gl::Program visibility_, attributes_, mesh_, resolve_, encode_;
  gl::VertexArray noAttributes_;
  gl::Buffer frameBlock_;
  SplatStore store_;
  // Of the last whole frame, which is picked from, and of the one that is being drawn.
  NodeList list_, next_;
  FrameTargets last_, current_;
  PictureTargets picture_;
  View view_;  // of the last frame, as the appearance
  Appearance appearance_;
  int frames_ = 0;  // in the mean
};

}  // namespace stipple
