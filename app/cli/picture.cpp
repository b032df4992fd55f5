#include "app/cli/picture.h"

#include <utility>

#include "render/hierarchy/jitter.h"
#include "render/raster/raster.h"
#include "render/raster/triangles.h"

namespace stipple {

namespace {

constexpr int kSpreadFrames = 16;
constexpr Rgba8 kGlyphColor{222, 56, 32, 255};  // told from dark and bright surfaces and backgrounds

}  // namespace

std::vector<glm::vec2> jitterOf(int supersample) {
  std::vector<glm::vec2> shifts;
  for (int i = 0; supersample == 0 && i < kSpreadFrames; ++i) shifts.push_back(jitterOfFrame(i));
  const float step = 1 / static_cast<float>(supersample);
  for (int y = 0; y < supersample; ++y) {
    for (int x = 0; x < supersample; ++x)
      shifts.emplace_back((static_cast<float>(x) + 0.5f) * step - 0.5f,
                          (static_cast<float>(y) + 0.5f) * step - 0.5f);
  }
  return shifts;
}

PictureMaker::PictureMaker(const Scene& scene, const RenderOptions& options, Renderer& renderer,
                           StageSeconds& seconds)
    : scene_(scene), options_(options), renderer_(renderer), seconds_(seconds) {
  const Index nodes = scene.hierarchy.nodeCount();
  if (nodes > 0) {
    seconds_.measure("upload", [&] { renderer_.upload(scene_.hierarchy, {{.begin = 0, .end = nodes}}); });
  }
}

Image PictureMaker::take(const CameraAngles& camera, Progress& progress) {
  const View view = frameView(scene_.sphere, camera, options_.width, options_.height);
  if (!options_.drawsTriangles) {
    cut_ = seconds_.measure("cut", [&] { return cutOf(view, progress); });
  }
  return seconds_.measure("draw", [&] {
    drawFrames(view, progress);
    Image image = renderer_.image();
    if (!scene_.glyphs.empty()) {
      drawGlyphs(image, depthOf(view, progress), view, scene_.glyphs, kGlyphColor);
    }
    return image;
  });
}

Cut PictureMaker::cutOf(const View& view, const Progress& progress) const {
  const auto select = [&](float tau) {
    return selectCut(scene_.hierarchy, view, {.tau = tau}, nullptr, &progress);
  };
  if (options_.tau > 0) return select(options_.tau);
  Cut cut = select(CutOptions().tau);
  if (options_.supersample == 1) return cut;
  // About half of the nodes is hidden.
  const float finer = tauOfMean(cut.tau, cut.nodes.size() / 2);
  return finer < cut.tau ? select(finer) : cut;
}

void PictureMaker::drawFrames(const View& view, Progress& progress) {
  const std::vector<glm::vec2> shifts = jitterOf(options_.supersample);
  Appearance appearance = options_.appearance;
  appearance.isOneOfMany = shifts.size() > 1;
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    progress.report(static_cast<double>(i) / static_cast<double>(shifts.size()), "drawing");
    progress.throwIfCancelled();
    View shifted = view;
    shifted.jitterPx = shifts[i];
    const Accumulate accumulate = i == 0 ? Accumulate::kStartAnew : Accumulate::kAddToMean;
    if (options_.drawsTriangles) {
      renderer_.drawMesh(scene_.mesh(), shifted, appearance, accumulate, &progress);
    } else {
      renderer_.draw(scene_.hierarchy, cut_.nodes, shifted, appearance, accumulate, &progress);
    }
  }
}

std::vector<float> PictureMaker::depthOf(const View& view, const Progress& progress) const {
  if (options_.drawsTriangles) {
    MeshLayer layer;
    rasterizeTriangles(scene_.mesh(), view, layer, &progress);
    return std::move(layer.depth);
  }
  FrameBuffers frame;
  Raster().draw(scene_.hierarchy.splats(), cut_.nodes, view, options_.appearance, frame, &progress);
  return std::move(frame.depth);
}

}  // namespace stipple
