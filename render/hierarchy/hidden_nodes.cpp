#include "render/hierarchy/hidden_nodes.h"

#include <algorithm>
#include <cmath>

#include "render/appearance/kernel.h"

namespace stipple {

namespace {

// Pixels about a pixel that are looked at. Larger discs stay.
constexpr int kWindow = 5;
// Of the shift, and of the pixel that a center lies in.
constexpr float kMarginPx = 2;
constexpr std::size_t kRows = 16, kNodes = 1 << 14;

// The farthest within the window, along one line of pixels after another.
std::vector<float> farthestAlong(std::span<const float> depth, int count, int lines, int step, int stride) {
  std::vector<float> farthest(depth.size());
  parallelFor(static_cast<std::size_t>(lines), kRows, [&](std::size_t begin, std::size_t end) {
    for (int at = 0; at < count; ++at) {
      const int first = std::max(at - kWindow, 0), last = std::min(at + kWindow, count - 1);
      for (std::size_t line = begin; line < end; ++line) {
        float most = 0;
        for (int i = first; i <= last; ++i) most = std::max(most, depth[line * stride + i * step]);
        farthest[line * stride + at * step] = most;
      }
    }
  });
  return farthest;
}

std::vector<float> farthestAbout(std::span<const float> depth, const View& view) {
  const std::vector<float> across = farthestAlong(depth, view.width, view.height, 1, view.width);
  return farthestAlong(across, view.height, view.width, view.width, 1);
}

}  // namespace

std::vector<Index> withoutHidden(const Hierarchy& hierarchy, std::span<const Index> nodes, const View& view,
                                 std::span<const float> depth) {
  const std::vector<float> farthest = farthestAbout(depth, view);
  const auto isHidden = [&](Index node) {
    const Splat& splat = hierarchy.splats()[node];
    const glm::vec3 place = view.toView(splat.center());
    const float nearest = place.z - splat.radius;
    if (!(nearest > view.nearDepth)) return false;
    if (view.pixelsPerUnit(nearest) * splat.radius + kernel::kOfOneFrame.radiusPx + kMarginPx > kWindow)
      return false;
    const glm::vec2 px = view.toPixels(place);
    // Beyond the border may lie a contour.
    if (!(px.x >= kWindow && px.y >= kWindow && px.x < static_cast<float>(view.width - kWindow) &&
          px.y < static_cast<float>(view.height - kWindow)))
      return false;
    const std::size_t pixel = static_cast<std::size_t>(px.y) * view.width + static_cast<std::size_t>(px.x);
    return nearest - kernel::kDepthBand * splat.radius > farthest[pixel];
  };
  std::vector<std::vector<Index>> blocks((nodes.size() + kNodes - 1) / kNodes);
  parallelFor(nodes.size(), kNodes, [&](std::size_t begin, std::size_t end) {
    std::vector<Index>& kept = blocks[begin / kNodes];
    for (const Index node : nodes.subspan(begin, end - begin)) {
      if (!isHidden(node)) kept.push_back(node);
    }
  });
  std::vector<Index> seen;
  for (const std::vector<Index>& block : blocks) seen.insert(seen.end(), block.begin(), block.end());
  return seen;
}

}  // namespace stipple
