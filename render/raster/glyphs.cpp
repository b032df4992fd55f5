#include "render/raster/glyphs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <unordered_map>

#include "render/appearance/light.h"

namespace stipple {

namespace {

glm::vec3 toGlm(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

// Points that keep a distance from each other: a grid whose cells are as wide as the distance holds those
// that were taken.
class SpacedChoice {
 public:
  SpacedChoice(const Eigen::Vector3f& corner, float distance) : corner_(corner), distance_(distance) {}

  // Takes the point where none of those taken is too near.
  bool take(const Eigen::Vector3f& p) {
    const Eigen::Vector3i cell = ((p - corner_) / distance_).array().floor().cast<int>();
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (hasNear(p, keyOf(cell + Eigen::Vector3i(dx, dy, dz)))) return false;
        }
      }
    }
    cells_[keyOf(cell)].push_back(p);
    return true;
  }

 private:
  // Cells are few enough along each axis, see kFinest.
  static std::uint64_t keyOf(const Eigen::Vector3i& cell) {
    const auto part = [](int coordinate) { return static_cast<std::uint64_t>(coordinate + 1) & 0x1fffff; };
    return part(cell.x()) << 42 | part(cell.y()) << 21 | part(cell.z());
  }
  bool hasNear(const Eigen::Vector3f& p, std::uint64_t key) const {
    const auto cell = cells_.find(key);
    return cell != cells_.end() && std::ranges::any_of(cell->second, [&](const Eigen::Vector3f& taken) {
             return (taken - p).squaredNorm() < distance_ * distance_;
           });
  }

  Eigen::Vector3f corner_;
  float distance_;
  std::unordered_map<std::uint64_t, std::vector<Eigen::Vector3f>> cells_;
};

struct Chosen {
  std::vector<Index> points;
  float distance = 0;  // that they keep
};

std::vector<Index> chooseApart(std::span<const Eigen::Vector3f> positions, std::span<const Index> candidates,
                               const Eigen::Vector3f& corner, float distance) {
  SpacedChoice choice(corner, distance);
  std::vector<Index> taken;
  for (const Index i : candidates) {
    if (choice.take(positions[i])) taken.push_back(i);
  }
  return taken;
}

// About `count` of the candidates, evenly spread, or all of them, at the distance that half of them would
// keep. The distance is found by trying: on a surface the number falls with its square.
Chosen chooseEvenly(std::span<const Eigen::Vector3f> positions, std::span<const Index> candidates,
                    Index count, const Progress* progress) {
  constexpr float kFinest = 1e-6f;  // of the extent: 2^20 cells along an axis
  constexpr int kTrials = 6;
  Eigen::Vector3f low = positions[candidates[0]], high = low;
  for (const Index i : candidates) {
    low = low.cwiseMin(positions[i]);
    high = high.cwiseMax(positions[i]);
  }
  const float extent = (high - low).norm();
  if (!(extent > 0)) return {{candidates[0]}, 1};
  const bool takesAll = candidates.size() <= count;
  const float wanted = takesAll ? 0.5f * static_cast<float>(candidates.size()) : static_cast<float>(count);
  Chosen chosen{{}, extent / std::sqrt(wanted)};
  for (int trial = 0; trial < kTrials; ++trial) {
    if (progress) progress->throwIfCancelled();
    chosen.points = chooseApart(positions, candidates, low, chosen.distance);
    const float ratio = static_cast<float>(chosen.points.size()) / wanted;
    if ((ratio > 0.9f && ratio < 1.1f) || trial + 1 == kTrials) break;
    chosen.distance = std::clamp(chosen.distance * std::sqrt(ratio), kFinest * extent, extent);
  }
  if (takesAll) chosen.points.assign(candidates.begin(), candidates.end());
  return chosen;
}

// So many that an even choice hardly notices the others missing.
constexpr std::size_t kCandidatesPerGlyph = 64;

std::vector<Index> findCandidates(std::span<const Eigen::Vector3f> vectors, Index count) {
  std::vector<Index> candidates;
  const std::size_t stride = std::max<std::size_t>(1, vectors.size() / (kCandidatesPerGlyph * count));
  for (std::size_t i = 0; i < vectors.size(); i += stride) {
    const float length = vectors[i].stableNorm();
    if (std::isfinite(length) && length > 0) candidates.push_back(static_cast<Index>(i));
  }
  return candidates;
}

}  // namespace

std::vector<Glyph> makeGlyphs(const PointSet& points, const std::string& attribute,
                              const GlyphOptions& options, const Progress* progress) {
  const auto vectors = points.values<Eigen::Vector3f>(attribute);
  const auto positions = points.positions();
  const std::vector<Index> candidates = findCandidates(vectors, std::max(options.count, Index{1}));
  if (candidates.empty()) return {};
  const Chosen chosen = chooseEvenly(positions, candidates, std::max(options.count, Index{1}), progress);

  std::vector<float> lengths;
  for (const Index i : chosen.points) lengths.push_back(vectors[i].stableNorm());
  const auto upper = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() * 19 / 20);
  std::ranges::nth_element(lengths, upper);
  const float longest = options.length * chosen.distance, unit = *upper;

  std::vector<Glyph> glyphs;
  for (const Index i : chosen.points) {
    const float length = longest * std::min(vectors[i].stableNorm() / unit, 1.f);
    const Eigen::Vector3f to = positions[i] + length * vectors[i].stableNormalized();
    glyphs.push_back({toGlm(positions[i]), toGlm(to)});
  }
  return glyphs;
}

namespace {

// A line as the picture shows it: its ends in pixels and 1 / depth (perspective) or depth there, which
// change linearly along the line.
struct ProjectedLine {
  glm::vec2 from{}, to{};
  float depthFrom = 0, depthTo = 0;
  float slack = 0;  // world: so far may the line dip below the surface that it stands on
};

class GlyphPainter {
 public:
  GlyphPainter(Image& image, std::span<const float> depth, const View& view, const Rgba8& color)
      : image_(image), depth_(depth), view_(view), color_(color) {}

  void draw(const Glyph& glyph) {
    const std::optional<ProjectedLine> line = project(glyph);
    if (!line) return;
    const glm::vec2 low = glm::min(line->from, line->to) - kReach,
                    high = glm::max(line->from, line->to) + kReach;
    const auto within = [](float value, int size) {
      return static_cast<int>(std::clamp(value, 0.f, static_cast<float>(size)));
    };
    const int rowEnd = within(std::ceil(high.y), view_.height);
    for (int row = within(std::floor(low.y), view_.height); row < rowEnd; ++row) {
      const auto [begin, end] = columnsOf(*line, row, low, high);
      const int columnEnd = within(std::ceil(end), view_.width);
      for (int column = within(std::floor(begin), view_.width); column < columnEnd; ++column)
        blend(*line, column, row);
    }
  }

 private:
  static constexpr float kHalfWidth = 0.6f;           // pixels
  static constexpr float kReach = kHalfWidth + 0.5f;  // and half a pixel of antialiasing
  static constexpr float kSlack = 0.25f;              // of the length of a line

  std::optional<ProjectedLine> project(const Glyph& glyph) const {
    glm::vec3 a = view_.toView(glyph.from), b = view_.toView(glyph.to);
    const float slack = kSlack * glm::length(b - a);
    const float near = view_.isPerspective() ? std::max(view_.nearDepth, 1e-30f) : view_.nearDepth;
    if (!(a.z >= near) && !(b.z >= near)) return std::nullopt;
    if (a.z < near) a += (b - a) * ((near - a.z) / (b.z - a.z));
    if (b.z < near) b += (a - b) * ((near - b.z) / (a.z - b.z));
    const auto depthOf = [&](float z) { return view_.isPerspective() ? 1 / z : z; };
    const ProjectedLine line{view_.toPixels(a), view_.toPixels(b), depthOf(a.z), depthOf(b.z), slack};
    const bool isFinite = std::isfinite(line.from.x + line.from.y + line.to.x + line.to.y);
    return isFinite ? std::optional(line) : std::nullopt;
  }

  // The part of a row that the line can touch.
  static std::pair<float, float> columnsOf(const ProjectedLine& line, int row, const glm::vec2& low,
                                           const glm::vec2& high) {
    const glm::vec2 direction = line.to - line.from;
    if (std::abs(direction.y) < 1) return {low.x, high.x};
    const float slope = direction.x / direction.y;
    const float middle = line.from.x + slope * (static_cast<float>(row) + 0.5f - line.from.y);
    const float half = kReach * std::sqrt(1 + slope * slope) + 1;
    return {std::max(low.x, middle - half), std::min(high.x, middle + half)};
  }

  void blend(const ProjectedLine& line, int column, int row) {
    const glm::vec2 center(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f);
    const glm::vec2 direction = line.to - line.from;
    const float squared = glm::dot(direction, direction);
    const float t =
        squared > 0 ? std::clamp(glm::dot(center - line.from, direction) / squared, 0.f, 1.f) : 0.f;
    const float distance = glm::length(center - (line.from + t * direction));
    const float cover = std::clamp(kReach - distance, 0.f, 1.f) * static_cast<float>(color_.a) / 255;
    if (cover <= 0 || isHidden(line, t, column, row)) return;
    mix(image_.at(column, row), cover);
  }

  bool isHidden(const ProjectedLine& line, float t, int column, int row) const {
    if (depth_.empty()) return false;
    const float mixed = line.depthFrom + t * (line.depthTo - line.depthFrom);
    const float depth = view_.isPerspective() ? 1 / mixed : mixed;
    const float slack = line.slack + 2 / view_.pixelsPerUnit(depth);  // and two pixels
    return depth > depth_[static_cast<std::size_t>(row) * view_.width + column] + slack;
  }

  // The line over the pixel, in linear light, straight alpha.
  void mix(Rgba8& pixel, float cover) const {
    const auto& linear = linearTable();
    const float below = (1 - cover) * static_cast<float>(pixel.a) / 255, alpha = cover + below;
    const auto channel = [&](std::uint8_t over, std::uint8_t under) {
      return encodeSrgb((cover * linear[over] + below * linear[under]) / alpha);
    };
    pixel = {channel(color_.r, pixel.r), channel(color_.g, pixel.g), channel(color_.b, pixel.b),
             static_cast<std::uint8_t>(std::lround(255 * alpha))};
  }

  Image& image_;
  std::span<const float> depth_;
  const View& view_;
  Rgba8 color_;
};

}  // namespace

void drawGlyphs(Image& image, std::span<const float> depth, const View& view, std::span<const Glyph> glyphs,
                const Rgba8& color) {
  assert(image.width == view.width && image.height == view.height);
  assert(depth.empty() || depth.size() == image.pixels.size());
  GlyphPainter painter(image, depth, view, color);
  for (const Glyph& glyph : glyphs) painter.draw(glyph);
}

}  // namespace stipple
