#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "app/cli/scene.h"
#include "render/appearance/image.h"

namespace stipple {

/// Shifts of the frames whose mean is a picture, pixels in [-0.5, 0.5]: N x N regular ones, or for 0 sixteen
/// well-spread ones (Halton).
std::vector<glm::vec2> jitterOf(int supersample);

/// Takes pictures of one scene.
class PictureMaker {
 public:
  /// Keeps references.
  PictureMaker(const Scene& scene, const RenderOptions& options, Renderer& renderer, StageSeconds& seconds);

  Image take(const CameraAngles& camera, Progress& progress);

  const char* backend() const { return renderer_.backend(); }
  /// Of the last picture.
  std::size_t splats() const { return cut_.nodes.size(); }

 private:
  Cut cutOf(const View& view, const Progress& progress) const;
  void drawFrames(const View& view, Progress& progress);
  std::vector<float> depthOf(const View& view, const Progress& progress) const;

  const Scene& scene_;
  const RenderOptions& options_;
  Renderer& renderer_;
  StageSeconds& seconds_;
  Cut cut_;
};

}  // namespace stipple
