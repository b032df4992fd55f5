#include "tests/bench/render/workbench.h"

#include "render/hierarchy/hidden_nodes.h"
#include "tests/support/sampled_hierarchy.h"

namespace stipple {

const scenes::SurfaceSamples& Workbench::samples() {
  if (!samples_) samples_ = torus.sample(options.points, 1);
  return *samples_;
}

Hierarchy& Workbench::hierarchy() {
  if (!hierarchy_) {
    hierarchy_ = buildHierarchy(leavesOf(samples()), LeafOrder::kKd);
    renderer.upload(*hierarchy_, {{0, hierarchy_->nodeCount()}});
  }
  return *hierarchy_;
}

const ReferencePicture& Workbench::reference() {
  if (!reference_) reference_ = castPicture(torus.surface, view(), appearance, 4);
  return *reference_;
}

View Workbench::view(float turned) const {
  return frameView(torus.surface.sphere, {.yaw = 0.3f + turned, .pitch = 0.67f}, options.width,
                   options.height);
}

void drawMeanOfFrames(Workbench& bench, const Hierarchy& hierarchy, const View& view, float tau, int frames) {
  Appearance appearance = bench.appearance;
  appearance.isOneOfMany = true;
  std::vector<Index> nodes = selectCut(hierarchy, view, {.tau = tau}).nodes;
  for (int frame = 0; frame < frames; ++frame) {
    View shifted = view;
    shifted.jitterPx = jitterOf(frame);
    bench.renderer.draw(hierarchy, nodes, shifted, appearance,
                        frame == 0 ? Accumulate::kStartAnew : Accumulate::kAddToMean, nullptr);
    if (frame == 0) nodes = withoutHidden(hierarchy, nodes, shifted, bench.renderer.depth());
  }
}

glm::vec2 jitterOf(int frame) {
  // Rows in bit-reversed order, so that any prefix is spread.
  constexpr std::array<int, 4> kOrder{0, 2, 1, 3};
  const glm::vec2 cell(kOrder[frame % 4], kOrder[(frame / 4 + frame) % 4]);
  return (cell + 0.5f) / 4.f - 0.5f;
}

}  // namespace stipple
