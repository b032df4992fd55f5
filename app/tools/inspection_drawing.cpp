#include "app/tools/inspection_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stipple {

namespace {

glm::vec3 toGlm(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

bool isCorner(const PointInspection& inspection, Index row) {
  return std::ranges::any_of(inspection.fan,
                             [&](const Triangle& t) { return std::ranges::find(t, row) != t.end(); });
}

void addFrame(const PointInspection& inspection, std::vector<ColoredSegment>& segments) {
  const Moments& moments = inspection.moments;
  const Eigen::Vector3f center = inspection.position + moments.centerOffset;
  const auto reach = [&](int axis) { return 2 * std::sqrt(std::max(moments.eigenvalues[axis], 0.f)); };
  const auto addAxis = [&](const Eigen::Vector3f& direction, float length, const Rgba8& color) {
    segments.push_back({toGlm(center), toGlm(center + length * direction), color});
  };
  addAxis(moments.axes.col(0), reach(0), kMajorAxisColor);
  addAxis(moments.axes.col(1), reach(1), kMinorAxisColor);
  const float sense = moments.axes.col(2).dot(inspection.normal) < 0 ? -1.f : 1.f;
  addAxis(sense * moments.axes.col(2), reach(1), kNormalColor);
}

}  // namespace

std::vector<ColoredSegment> segmentsOf(const PointInspection& inspection, const PointSet& points) {
  std::vector<ColoredSegment> segments;
  const auto place = [&](Index row) { return toGlm(points.positions()[row]); };
  const glm::vec3 site = toGlm(inspection.position);
  for (const Index neighbor : inspection.neighbors)
    segments.push_back({site, place(neighbor), kNeighborColor});
  for (const Triangle& t : inspection.fan) {
    for (std::size_t c = 0; c < 3; ++c) segments.push_back({place(t[c]), place(t[(c + 1) % 3]), kFanColor});
  }
  for (const MatrixEntry& entry : inspection.matrixRow) {
    const bool isOwn = points.positions()[entry.column] == inspection.position;
    if (!isOwn && !isCorner(inspection, entry.column))
      segments.push_back({site, place(entry.column), kForeignColumnColor});
  }
  addFrame(inspection, segments);
  return segments;
}

std::vector<std::string> linesOf(const PointInspection& inspection) {
  const Moments& moments = inspection.moments;
  const Eigen::Vector3f &l = moments.eigenvalues, &n = inspection.normal;
  std::vector<std::string> lines{
      fmt::format("point {}: {} neighbors within {:.4g}", inspection.row, inspection.neighbors.size(),
                  moments.radius),
      fmt::format("eigenvalues {:.3g}, {:.3g}, {:.3g}; classifier {:.3f}", l[0], l[1], l[2],
                  inspection.classifier),
      fmt::format("normal ({:.3f}, {:.3f}, {:.3f}); steepest turn {:.1f} degrees", n.x(), n.y(), n.z(),
                  inspection.steepestTurn * 180 / std::numbers::pi_v<float>),
      fmt::format("fan of {} triangles: {}, {}, {}", inspection.fan.size(),
                  inspection.isOpen ? "open" : "closed",
                  inspection.isCertified ? "certified" : "not certified",
                  inspection.isResolved ? "agreed with its neighbors" : "not agreed with its neighbors")};
  const auto diagonal = std::ranges::max_element(inspection.matrixRow, {}, &MatrixEntry::value);
  if (diagonal != inspection.matrixRow.end()) {
    lines.push_back(fmt::format("matrix row of {} entries, diagonal {:.4g}; mass {:.4g}",
                                inspection.matrixRow.size(), diagonal->value, inspection.mass));
  }
  if (!inspection.isSettled) lines.push_back("this depends on more of the surface than was looked at");
  return lines;
}

}  // namespace stipple
