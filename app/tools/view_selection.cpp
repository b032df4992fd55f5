#include "app/tools/view_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "core/error.h"

namespace stipple {

namespace {

constexpr std::size_t kBlock = 1 << 14;
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
  bool isSeen = false;
  glm::vec2 px{};
  float depth = 0;
};

// Answers for one point at a time. Whether it is hidden is no branch: the order of the rows says nothing.
class Looker {
 public:
  explicit Looker(const SeenPoints& points)
      : view_(points.view),
        positions_(points.positions),
        depth_(points.depth),
        tolerance_(points.tolerance),
        center_(view_.centerPx()),
        size_(static_cast<float>(view_.width), static_cast<float>(view_.height)) {}

  template <class Within>
  Seen look(Index row, const Within& within) const {
    const Eigen::Vector3f& p = positions_[row];
    const glm::vec3 inView = view_.toView({p.x(), p.y(), p.z()});
    const float scale = view_.pixelsPerUnit(inView.z);
    Seen seen{.px = center_ + scale * glm::vec2(inView.x, inView.y), .depth = inView.z};
    const bool isInside = (inView.z >= view_.nearDepth) & (seen.px.x >= 0) & (seen.px.y >= 0) &
                          (seen.px.x < size_.x) & (seen.px.y < size_.y);
    // Most shapes take nearly all or nearly none; not a number is not converted.
    if (!isInside) return seen;
    const auto at =
        static_cast<Index>(seen.px.y) * static_cast<Index>(view_.width) + static_cast<Index>(seen.px.x);
    if (!within(seen.px, at)) return seen;
    seen.isSeen = depth_.empty() || inView.z <= depth_[at] + std::max(tolerance_, kTolerancePx / scale);
    return seen;
  }

 private:
  const View view_;
  std::span<const Eigen::Vector3f> positions_;
  std::span<const float> depth_;
  float tolerance_;
  glm::vec2 center_, size_;
};

std::vector<Index> concatenate(const std::vector<std::vector<Index>>& parts) {
  std::vector<std::size_t> begins{0};
  for (const auto& part : parts) begins.push_back(begins.back() + part.size());
  std::vector<Index> all(begins.back());
  parallelFor(parts.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      std::ranges::copy(parts[p], all.begin() + static_cast<std::ptrdiff_t>(begins[p]));
  });
  return all;
}

// `within(px, pixel)`: the position and the number of its pixel.
template <class Within>
std::vector<Index> findWithin(const SeenPoints& points, const Within& within, const Progress* progress) {
  checkDepth(points);
  if (points.view.width <= 0 || points.view.height <= 0) return {};
  const Looker looker(points);
  std::vector<std::vector<Index>> parts((points.positions.size() + kBlock - 1) / kBlock);
  parallelFor(
      points.positions.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        std::array<Index, kBlock> rows;
        std::size_t count = 0;
        for (auto row = static_cast<Index>(begin); row < end; ++row) {
          rows[count] = row;
          count += looker.look(row, within).isSeen ? 1 : 0;
        }
        parts[begin / kBlock].assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count));
      },
      progress);
  return concatenate(parts);
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

  bool isEmpty() const { return inside_.empty(); }
  bool contains(Index pixel) const { return inside_[pixel] != 0; }

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

std::vector<Index> findInRectangle(const SeenPoints& points, const ScreenRectangle& rectangle,
                                   const Progress* progress) {
  const glm::vec2 low = glm::min(rectangle.corner, rectangle.opposite);
  const glm::vec2 high = glm::max(rectangle.corner, rectangle.opposite);
  return findWithin(
      points,
      [&](const glm::vec2& px, Index) {
        return (px.x >= low.x) & (px.y >= low.y) & (px.x <= high.x) & (px.y <= high.y);
      },
      progress);
}

std::vector<Index> findInLasso(const SeenPoints& points, std::span<const glm::vec2> polygon,
                               const Progress* progress) {
  for (const glm::vec2& corner : polygon) {
    if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) return {};
  }
  const PolygonMask mask(polygon, points.view.width, points.view.height);
  if (mask.isEmpty()) return {};
  return findWithin(
      points, [&](const glm::vec2&, Index pixel) { return mask.contains(pixel); }, progress);
}

std::optional<Index> findClicked(const SeenPoints& points, const glm::vec2& px, float radiusPx) {
  checkDepth(points);
  if (points.view.width <= 0 || points.view.height <= 0) return std::nullopt;
  using Rank = std::tuple<float, float, Index>;  // squared distance in the picture, depth, row
  constexpr float kFar = std::numeric_limits<float>::infinity();
  const Looker looker(points);
  std::vector<Rank> best((points.positions.size() + kBlock - 1) / kBlock, Rank{kFar, kFar, 0});
  const auto squaredDistance = [&](const glm::vec2& at) { return glm::dot(at - px, at - px); };
  parallelFor(points.positions.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    Rank& least = best[begin / kBlock];
    for (auto row = static_cast<Index>(begin); row < end; ++row) {
      const Seen seen = looker.look(
          row, [&](const glm::vec2& at, Index) { return squaredDistance(at) <= radiusPx * radiusPx; });
      if (seen.isSeen) least = std::min(least, Rank{squaredDistance(seen.px), seen.depth, row});
    }
  });
  const auto least = std::ranges::min_element(best);
  if (least == best.end() || std::get<0>(*least) == kFar) return std::nullopt;
  return std::get<2>(*least);
}

}  // namespace stipple
