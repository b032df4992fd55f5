#include "render/splat/frame_block.h"

#include "render/appearance/kernel.h"
#include "render/appearance/light.h"

namespace stipple {

namespace {

glm::vec3 linearOf(const Rgba8& color) {
  return {linearTable()[color.r], linearTable()[color.g], linearTable()[color.b]};
}

void setView(FrameBlock& block, const View& view) {
  for (int column = 0; column < 3; ++column) {
    block.viewFromWorld[column] = glm::vec4(view.viewFromWorld[column], 0);
  }
  block.eye = view.eye;
  block.focalPx = view.focalPx;
  block.principalPx = view.centerPx();
  block.sizePx = {view.width, view.height};
  block.nearDepth = view.nearDepth;
  block.isPerspective = view.isPerspective();
  // scale / (shift + depth) lies in (0, 1]; where depth begins at 0, the height of the picture sets the
  // scale.
  const float height = static_cast<float>(view.height) / view.focalPx;
  block.depthScale = view.isPerspective() ? view.nearDepth : height;
  block.depthShift = view.isPerspective() ? 0 : height;
}

void setKernelAndLight(FrameBlock& block, bool isOneOfMany) {
  const kernel::ScreenKernel& screen = kernel::screenKernelOf(isOneOfMany);
  block.leastCosine = kernel::kLeastCosine;
  block.screenRadiusPx = screen.radiusPx;
  block.smallDiscPx = screen.smallDiscPx;
  block.leastScreenRadiusPx = screen.leastRadiusPx;
  block.visibleShare = kernel::kVisibleShare;
  block.depthBand = kernel::kDepthBand;
  block.normalCosine = kernel::kNormalCosine;
  block.leastWeight = kernel::kLeastWeight;
  block.ringPx = kernel::kRingPx;
  block.ringFill = kernel::kRingFill;
  block.keyLight = light::kKey;
  block.ambient = light::kAmbient;
  block.diffuse = light::kDiffuse;
  block.headLight = light::kHead;
}

}  // namespace

FrameBlock makeFrameBlock(const View& view, const Appearance& appearance, bool isBlended) {
  FrameBlock block{};
  setView(block, view);
  setKernelAndLight(block, appearance.isOneOfMany);
  block.selectionColor = linearOf(appearance.selectionColor);
  block.selectionShare = kernel::kSelectionShare;
  if (appearance.brush) {
    block.brushCenter = view.toView(appearance.brush->center);
    block.brushRadius = appearance.brush->radius;
    block.brushColor = linearOf(appearance.brush->color);
  }
  if (appearance.background) {
    block.background = glm::vec4(linearOf(*appearance.background), 1);
  }
  // One picture height away darkens as much in both projections and at any size of the picture.
  block.edgeStrength = kernel::kEdgeStrength * static_cast<float>(view.height) * appearance.edgeStrength;
  block.isLit = appearance.lit;
  block.isTwoSided = appearance.twoSided;
  block.splatMode = static_cast<std::uint32_t>(appearance.mode);
  block.isBlended = isBlended;
  block.isOneOfMany = appearance.isOneOfMany;
  return block;
}

}  // namespace stipple
