#include "tests/support/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stipple {

namespace {

/// Points on a sphere along a spiral: as even as the corners of a dodecahedron, but none looks along an axis.
CameraAngles directionOf(int i) {
  constexpr float kTurn = 2 * std::numbers::pi_v<float> * 0.618034f;
  const float height = (2 * static_cast<float>(i) + 1) / 20 - 1;
  return {.yaw = 0.1f + kTurn * static_cast<float>(i), .pitch = std::asin(height)};
}

}  // namespace

std::vector<CoverageView> lookFromAllSides(Renderer& renderer, const CoverageSubject& subject,
                                           const CoverageOptions& options) {
  Appearance appearance;
  appearance.edgeStrength = 0;
  renderer.upload(subject.hierarchy, {{0, subject.hierarchy.nodeCount()}});
  std::vector<CoverageView> views;
  for (int i = 0; i < options.directions; ++i) {
    // Fewer directions are spread over all of them.
    CameraAngles angles = directionOf(i * 20 / options.directions);
    for (const float zoom : options.zooms) {
      angles.zoom = zoom;
      const View view = frameView(subject.truth.sphere, angles, options.side, options.side);
      const ReferencePicture reference = castPicture(subject.truth, view, appearance, 1);
      const Cut cut = selectCut(subject.hierarchy, view, {.tau = options.tau});
      renderer.draw(subject.hierarchy, cut.nodes, view, appearance, Accumulate::kStartAnew);
      views.push_back({angles, comparePictures(reference, takePicture(renderer), 3 * subject.spacing)});
    }
  }
  return views;
}

std::string describeWorst(const std::vector<CoverageView>& views) {
  const auto worst = std::ranges::max_element(views, {}, &CoverageView::stray);
  if (worst == views.end()) return "no views";
  return fmt::format("yaw {:.3f} pitch {:.3f} zoom {:.1f}: {} holes, {} see-through, {} fringe of {} pixels",
                     worst->angles.yaw, worst->angles.pitch, worst->angles.zoom, worst->errors.holes,
                     worst->errors.seeThrough, worst->errors.fringe, worst->errors.covered);
}

}  // namespace stipple
