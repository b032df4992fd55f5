#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/parallel.h"

namespace stipple {

/// A neighbor in the tangent plane of a site that lies at the origin.
struct PlanePoint {
  double x = 0, y = 0;
  double squaredNorm = 0;
  Index site = 0;
};

/// Orthonormal right-handed frame to the last bits of double: the normal made exactly unit, and two tangents
/// that are a function of the normal alone.
struct TangentBasis {
  Eigen::Vector3d e0, e1, normal;
};
TangentBasis tangentBasisOf(const Eigen::Vector3f& normal);

/// Delaunay star of the origin among points of the plane: the Voronoi cell of the origin, cut out of the
/// square
/// [-box, box]^2 by one bisector after another (mathematics of the fans: Section 5 of the paper; by cell
/// clipping).
class LocalFan {
 public:
  struct Spoke {
    std::uint32_t point = 0;  ///< index into the points
    bool gapAfter = false;    ///< the cell meets the square between this neighbor and the next: no triangle
  };

  /// `points` by ascending norm, none at the origin. Signs in doubt are decided by exact predicates.
  void clip(std::span<const PlanePoint> points, double box);
  /// Drops the far end of the shortest edge of the worst triangle while a triangle has an angle below
  /// `minAngle`, at most 10 times, never opening the fan or leaving fewer than 4 spokes (Section 6). Removes
  /// from `points` too.
  void clipWithMinAngle(std::vector<PlanePoint>& points, double box, double minAngle);

  /// Counterclockwise; starts after a gap where there is one.
  std::span<const Spoke> spokes() const { return spokes_; }
  bool open() const { return open_; }
  /// Squared distance of the farthest corner of the cell.
  double squaredReach() const { return squaredReach_; }

 private:
  struct Corner {
    double x, y, error;
  };
  struct Cell {
    std::vector<Corner> corners;  // corner c lies between the edges c - 1 and c
    std::vector<int> edges;       // point of the bisector that edge c lies on; negative: a side of the square
  };
  bool isCut(std::span<const PlanePoint> points, std::size_t corner, std::size_t by, double& height) const;
  Corner meet(std::span<const PlanePoint> points, std::size_t edge, int by, double before,
              double after) const;
  void cut(std::span<const PlanePoint> points, std::size_t by);
  void collectSpokes();

  Cell cell_, next_;
  std::vector<double> heights_;
  std::vector<std::uint8_t> removed_;
  std::vector<Spoke> spokes_;
  double squaredReach_ = 0;
  bool open_ = false;
};

/// +1 where d lies inside the circle through the origin, a and b (counterclockwise), -1 outside, 0 on it.
/// Exact.
int insideCircleOfOrigin(const PlanePoint& a, const PlanePoint& b, const PlanePoint& d);

}  // namespace stipple
