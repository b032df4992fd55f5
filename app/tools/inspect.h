#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/discretization.h"
#include "core/geometry/moments.h"
#include "core/points/point_set.h"

namespace stipple {

/// An entry of a row of the stiffness matrix.
struct MatrixEntry {
  Index column;  ///< file row
  double value;  ///< dimensionless
};

/// What finite elements are made of at one point. Where a place has several file rows, the first stands for
/// all.
struct PointInspection {
  Index row = 0;
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< world

  std::vector<Index> neighbors = {};  ///< file rows that the moments are of, nearest first
  Moments moments = {};
  float classifier = 1;  ///< C in (0, 1], see classify

  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< of the fan's plane; sign as below
  std::vector<Triangle> fan = {};  ///< file rows, the point first, counterclockwise about the normal
  bool isOpen = false;             ///< the fan does not close round the point
  bool isCertified = false;        ///< no point beyond those looked at can change the fan
  bool isResolved = false;         ///< it consists of triangles that the fans around agree on
  float steepestTurn = 0;          ///< between the one-sided planes of the point and of the fan, radians

  std::vector<MatrixEntry> matrixRow = {};  ///< columns ascending, with the diagonal
  double mass = 0;                          ///< length^2
  bool isSettled = true;                    ///< four times the surroundings give the same
};

/// Discretizes as many surroundings of a point as its row depends on, some thousand points as a rule, and at
/// most 65 536. Normal and fan agree with the attribute `normal`; without it the largest component is
/// positive. Throws InvalidInput where there is no such row, its position is not finite, or as discretize
/// does.
PointInspection inspectPoint(const PointSet& points, Index row, const DiscretizationOptions& options = {},
                             const Progress* progress = nullptr);

}  // namespace stipple
