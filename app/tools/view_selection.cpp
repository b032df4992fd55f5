#include "app/tools/view_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "core/error.h"

namespace stipple {

namespace {

constexpr std::size_t kBlock = 1 << 16;
// Of what a pixel covers: surfaces change their depth across it.
constexpr float kTolerancePx = 3;

void checkDepth(const SeenPoints& points) {
  const auto pixels =
      static_cast<std::size_t>(points.view.width) * static_cast<std::size_t>(points.view.height);
  if (points.depth.empty() || points.depth.size() == pixels) return;
  throw InvalidInput(fmt::format("the depth has {} values, expected {} x {}", points.depth.size(),
                                 points.view.width, points.view.height));
}

struct Seen {
  glm::vec2 px{};
  float depth = 0;
};

// Answers for one point at a time; rejects by `within(px)` before it looks at the depth.
class Looker {
 public:
  explicit Looker(const SeenPoints& points)
      : points_(points),
        size_(static_cast<float>(points.view.width), static_cast<float>(points.view.height)) {}

  template <class Within>
  std::optional<Seen> look(Index row, const Within& within) const {
    const Eigen::Vector3f& p = points_.positions[row];
    const glm::vec3 inView = points_.view.toView({p.x(), p.y(), p.z()});
    if (!(inView.z >= points_.view.nearDepth)) return std::nullopt;
    const glm::vec2 px = points_.view.toPixels(inView);
    if (!(px.x >= 0 && px.y >= 0 && px.x < size_.x && px.y < size_.y) || !within(px)) return std::nullopt;
    if (!points_.depth.empty()) {
      const auto at = static_cast<std::size_t>(px.y) * static_cast<std::size_t>(points_.view.width) +
                      static_cast<std::size_t>(px.x);
      const float allowed = std::max(points_.tolerance, kTolerancePx / points_.view.pixelsPerUnit(inView.z));
      if (inView.z > points_.depth[at] + allowed) return std::nullopt;
    }
    return Seen{px, inView.z};
  }

 private:
  const SeenPoints& points_;
  glm::vec2 size_;
};

template <class Within>
std::vector<Index> findWithin(const SeenPoints& points, const Within& within, const Progress* progress) {
  checkDepth(points);
  const Looker looker(points);
  std::vector<std::vector<Index>> parts((points.positions.size() + kBlock - 1) / kBlock);
  parallelFor(
      points.positions.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Index>& part = parts[begin / kBlock];
        for (auto row = static_cast<Index>(begin); row < end; ++row) {
          if (looker.look(row, within)) part.push_back(row);
        }
      },
      progress);
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<Index> rows;
  rows.reserve(total);
  for (const auto& part : parts) rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

// The pixels whose centers lie inside a polygon.
class PolygonMask {
 public:
  PolygonMask(std::span<const glm::vec2> polygon, int width, int height) : width_(width) {
    if (polygon.size() < 3 || width <= 0 || height <= 0) return;
    inside_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    std::vector<float> crossings;
    for (int y = 0; y < height; ++y) {
      findCrossings(polygon, static_cast<float>(y) + 0.5f, crossings);
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) fill(y, crossings[c], crossings[c + 1]);
    }
  }

  bool contains(const glm::vec2& px) const {
    if (inside_.empty()) return false;
    return inside_[static_cast<std::size_t>(px.y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(px.x)] != 0;
  }

 private:
  static void findCrossings(std::span<const glm::vec2> polygon, float y, std::vector<float>& crossings) {
    crossings.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
  }
  void fill(int y, float from, float to) {
    const auto column = [&](float x) {
      return static_cast<std::ptrdiff_t>(std::clamp(std::ceil(x - 0.5f), 0.f, static_cast<float>(width_)));
    };
    const auto row = inside_.begin() + static_cast<std::ptrdiff_t>(y) * width_;
    std::fill(row + column(from), row + column(to), std::uint8_t{1});
  }

  int width_;
  std::vector<std::uint8_t> inside_;
};

}  // namespace

std::vector<Index> findInRectangle(const SeenPoints& points, const PixelRectangle& rectangle,
                                   const Progress* progress) {
  const glm::vec2 low = glm::min(rectangle.corner, rectangle.opposite);
  const glm::vec2 high = glm::max(rectangle.corner, rectangle.opposite);
  return findWithin(
      points,
      [&](const glm::vec2& px) { return px.x >= low.x && px.y >= low.y && px.x <= high.x && px.y <= high.y; },
      progress);
}

std::vector<Index> findInLasso(const SeenPoints& points, std::span<const glm::vec2> polygon,
                               const Progress* progress) {
  for (const glm::vec2& corner : polygon) {
    if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) return {};
  }
  const PolygonMask mask(polygon, points.view.width, points.view.height);
  return findWithin(
      points, [&](const glm::vec2& px) { return mask.contains(px); }, progress);
}

std::optional<Index> findClicked(const SeenPoints& points, const glm::vec2& px, float radiusPx) {
  checkDepth(points);
  using Rank = std::tuple<float, float, Index>;  // squared distance in the picture, depth, row
  constexpr float kFar = std::numeric_limits<float>::infinity();
  const Looker looker(points);
  std::vector<Rank> best((points.positions.size() + kBlock - 1) / kBlock, Rank{kFar, kFar, 0});
  const auto squaredDistance = [&](const glm::vec2& at) { return glm::dot(at - px, at - px); };
  parallelFor(points.positions.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    Rank& least = best[begin / kBlock];
    for (auto row = static_cast<Index>(begin); row < end; ++row) {
      const auto seen =
          looker.look(row, [&](const glm::vec2& at) { return squaredDistance(at) <= radiusPx * radiusPx; });
      if (seen) least = std::min(least, Rank{squaredDistance(seen->px), seen->depth, row});
    }
  });
  const auto least = std::ranges::min_element(best);
  if (least == best.end() || std::get<0>(*least) == kFar) return std::nullopt;
  return std::get<2>(*least);
}

}  // namespace stipple
