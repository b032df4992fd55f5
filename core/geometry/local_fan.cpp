#include "core/geometry/local_fan.h"

#include <algorithm>
#include <cmath>

namespace stipple {

TangentBasis tangentBasisOf(const Eigen::Vector3f& normal) {
  // Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
  const Eigen::Vector3d n = normal.cast<double>().normalized();
  const double sign = std::copysign(1.0, n.z());
  const double a = -1.0 / (sign + n.z()), b = n.x() * n.y() * a;
  return {
      {1.0 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()}, {b, sign + n.y() * n.y() * a, -n.y()}, n};
}

// Height of the corner over the bisector of the point; above it the corner belongs to the point's cell.
bool LocalFan::isCut(std::span<const PlanePoint> points, std::size_t corner, std::size_t by,
                     double& height) const {
  const Corner& c = cell_.corners[corner];
  const PlanePoint& p = points[by];
  height = c.x * p.x + c.y * p.y - 0.5 * p.squaredNorm;
  const int before = cell_.edges[corner == 0 ? cell_.edges.size() - 1 : corner - 1],
            after = cell_.edges[corner];
  const double doubt = c.error * (std::abs(p.x) + std::abs(p.y)) + 1e-15 * p.squaredNorm;
  if (std::abs(height) > doubt || before < 0 || after < 0) return height > 0;
  return insideCircleOfOrigin(points[static_cast<std::size_t>(before)],
                              points[static_cast<std::size_t>(after)], p) > 0;
}

// Where the bisector of `by` meets an edge whose ends have the given heights over it.
LocalFan::Corner LocalFan::meet(std::span<const PlanePoint> points, std::size_t edge, int by, double before,
                                double after) const {
  const int label = cell_.edges[edge];
  const PlanePoint& q = points[static_cast<std::size_t>(by)];
  if (label >= 0) {
    // The circumcenter of origin, p and q, from their coordinates: errors do not add up from cut to cut.
    const PlanePoint& p = points[static_cast<std::size_t>(label)];
    const double area = 2 * (p.x * q.y - p.y * q.x);
    const double size =
        p.squaredNorm * (std::abs(q.x) + std::abs(q.y)) + q.squaredNorm * (std::abs(p.x) + std::abs(p.y));
    const Corner center{(p.squaredNorm * q.y - q.squaredNorm * p.y) / area,
                        (q.squaredNorm * p.x - p.squaredNorm * q.x) / area, 1e-15 * size / std::abs(area)};
    if (std::isfinite(center.x) && std::isfinite(center.y)) return center;
  }
  const Corner& a = cell_.corners[edge];
  const Corner& b = cell_.corners[edge + 1 == cell_.corners.size() ? 0 : edge + 1];
  const double t = before == after ? 0.5 : std::clamp(before / (before - after), 0.0, 1.0);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0};
}

void LocalFan::cut(std::span<const PlanePoint> points, std::size_t by) {
  const std::size_t count = cell_.corners.size();
  heights_.resize(count);
  removed_.resize(count);
  std::size_t gone = 0;
  for (std::size_t c = 0; c < count; ++c) gone += removed_[c] = isCut(points, c, by, heights_[c]);
  if (gone == 0 || gone == count) return;

  next_.corners.clear();
  next_.edges.clear();
  squaredReach_ = 0;
  const auto keep = [&](const Corner& corner, int edge) {
    next_.corners.push_back(corner);
    next_.edges.push_back(edge);
    squaredReach_ = std::max(squaredReach_, corner.x * corner.x + corner.y * corner.y);
  };
  const int label = static_cast<int>(by);
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t d = c + 1 == count ? 0 : c + 1;
    if (!removed_[c]) keep(cell_.corners[c], cell_.edges[c]);
    if (!removed_[c] && removed_[d]) keep(meet(points, c, label, heights_[c], heights_[d]), label);
    if (removed_[c] && !removed_[d]) keep(meet(points, c, label, heights_[c], heights_[d]), cell_.edges[c]);
  }
  std::swap(cell_, next_);
}

void LocalFan::clip(std::span<const PlanePoint> points, double box) {
  cell_.corners.assign({{box, -box, 0}, {box, box, 0}, {-box, box, 0}, {-box, -box, 0}});
  cell_.edges.assign({-1, -2, -3, -4});
  squaredReach_ = 2 * box * box;
  for (std::size_t p = 0; p < points.size(); ++p) {
    // Points twice as far as the farthest corner, and all after them, leave the cell alone; the slack is that
    // of the tie-breaking shifts, by which the norms may be out of order.
    if (points[p].squaredNorm > 4.0001 * squaredReach_) break;
    cut(points, p);
  }
  collectSpokes();
}

void LocalFan::collectSpokes() {
  const std::size_t count = cell_.edges.size();
  std::size_t start = 0;
  open_ = false;
  for (std::size_t e = 0; e < count; ++e) {
    if (cell_.edges[e] < 0) {
      open_ = true;
      start = e;
    }
  }
  spokes_.clear();
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t e = (start + s) % count;
    if (cell_.edges[e] >= 0) {
      spokes_.push_back({static_cast<std::uint32_t>(cell_.edges[e]), false});
    } else if (!spokes_.empty()) {
      spokes_.back().gapAfter = true;
    }
  }
  if (open_ && !spokes_.empty()) spokes_.back().gapAfter = true;
}

namespace {

struct Triangle2 {
  double smallestAngle;
  bool dropSecond;  // which of the two outer corners the rule removes
};

Triangle2 judge(const PlanePoint& p, const PlanePoint& q) {
  const auto angle = [](double ax, double ay, double bx, double by) {
    return std::atan2(std::abs(ax * by - ay * bx), ax * bx + ay * by);
  };
  const double atCenter = angle(p.x, p.y, q.x, q.y), atP = angle(-p.x, -p.y, q.x - p.x, q.y - p.y);
  const double atQ = 3.14159265358979323846 - atCenter - atP;
  const double smallest = std::min({atCenter, atP, atQ});
  // The smallest angle faces the shortest edge: pq (the farther end goes), center-q or center-p.
  if (smallest == atCenter) return {smallest, q.squaredNorm >= p.squaredNorm};
  return {smallest, smallest == atP};
}

}  // namespace

void LocalFan::clipWithMinAngle(std::vector<PlanePoint>& points, double box, double minAngle) {
  clip(points, box);
  for (int round = 0; round < 10; ++round) {
    double worst = minAngle;
    std::uint32_t drop = 0;
    for (std::size_t s = 0; s < spokes_.size(); ++s) {
      if (spokes_[s].gapAfter) continue;
      const std::uint32_t p = spokes_[s].point, q = spokes_[(s + 1) % spokes_.size()].point;
      const Triangle2 triangle = judge(points[p], points[q]);
      if (triangle.smallestAngle >= worst) continue;
      worst = triangle.smallestAngle;
      drop = triangle.dropSecond ? q : p;
    }
    if (worst == minAngle || spokes_.size() <= 4) return;
    const bool wasOpen = open_;
    const PlanePoint dropped = points[drop];
    points.erase(points.begin() + drop);
    clip(points, box);
    if (open_ && !wasOpen) {
      points.insert(points.begin() + drop, dropped);
      clip(points, box);
      return;
    }
  }
}

}  // namespace stipple
