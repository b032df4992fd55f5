#include "tests/support/popping.h"

#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

using Mask = std::vector<std::uint8_t>;
constexpr int kTile = 16;

struct PathFrame {
  ReferencePicture truth;
  DrawnPicture drawn;
};

Mask coveredInBoth(const ReferencePicture& a, const ReferencePicture& b) {
  Mask mask(a.hits.size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = a.isCovered(i) && b.isCovered(i);
  return mask;
}

double excessChange(const PathFrame& last, const PathFrame& next, const Mask& mask) {
  return meanDifference(last.drawn.image, next.drawn.image, mask) -
         meanDifference(last.truth.image, next.truth.image, mask);
}

/// Of tiles that the surface covers in both frames.
double worstTileExcess(const PathFrame& last, const PathFrame& next, const Mask& mask) {
  const int width = last.truth.image.width, height = last.truth.image.height;
  double worst = 0;
  for (int top = 0; top + kTile <= height; top += kTile) {
    for (int left = 0; left + kTile <= width; left += kTile) {
      double excess = 0;
      bool isCovered = true;
      for (int y = top; y < top + kTile; ++y) {
        for (int x = left; x < left + kTile; ++x) {
          isCovered = isCovered && mask[static_cast<std::size_t>(y) * width + x];
          const auto change = [x, y](const Image& a, const Image& b) {
            const Rgba8 p = a.at(x, y), q = b.at(x, y);
            return std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
          };
          excess += change(last.drawn.image, next.drawn.image) - change(last.truth.image, next.truth.image);
        }
      }
      if (isCovered) worst = std::max(worst, excess / (3 * kTile * kTile));
    }
  }
  return worst;
}

}  // namespace

Popping measurePopping(Renderer& renderer, const Hierarchy& hierarchy, const scenes::RaySurface& truth,
                       const ZoomPath& path, const CutOptions& options) {
  Appearance appearance;
  appearance.edgeStrength = 0;
  renderer.upload(hierarchy, {{0, hierarchy.nodeCount()}});
  Popping popping;
  CutMemory memory;
  PathFrame last;
  for (int frame = 0; frame < path.frames; ++frame) {
    CameraAngles angles = path.start;
    const float share = static_cast<float>(frame) / static_cast<float>(std::max(path.frames - 1, 1));
    angles.zoom *= std::pow(path.lastZoom / path.start.zoom, share);
    const View view = frameView(truth.sphere, angles, path.width, path.height);
    const Cut cut = selectCut(hierarchy, view, options, &memory);
    renderer.draw(hierarchy, cut.nodes, view, appearance, Accumulate::kStartAnew);
    PathFrame next{castPicture(truth, view, appearance, 2), takePicture(renderer)};
    popping.incompleteFrames += !cut.isComplete;
    popping.holes += comparePictures(next.truth, next.drawn, kNoDepth).holes;
    if (frame > 0) {
      const Mask mask = coveredInBoth(last.truth, next.truth);
      const double excess = excessChange(last, next, mask);
      if (excess > popping.worst) {
        popping.worst = excess;
        popping.worstFrame = frame;
      }
      popping.worstTile = std::max(popping.worstTile, worstTileExcess(last, next, mask));
      popping.motion += meanDifference(last.truth.image, next.truth.image, mask) / (path.frames - 1);
    }
    last = std::move(next);
  }
  return popping;
}

}  // namespace stipple
