#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/sites.h"
#include "core/progress.h"

namespace stipple {

/// The plane of the smooth piece of surface that a site lies on: beside a crease that of one side, never the
/// mean.
struct OneSidedPlane {
  Eigen::Vector3f center;  ///< barycenter of the points it was fitted to
  Eigen::Vector3f normal;  ///< unit, sign arbitrary
};

struct CreaseOptions {
  int k = 48;        ///< neighbors among whose planes a site chooses; see creaseNeighbors
  double noise = 0;  ///< standard deviation across the surface in mean spacings; see estimateNoise
};

/// Planes are fitted to the k/4 nearest of every site (at least 6); of those within the k nearest a site
/// takes the flattest one that it lies on within the noise (Kuwahara's filter, 1976, with planes for means).
/// Where none is flat, as between the sheets of a blade, it looks at up to four times as many.
std::vector<OneSidedPlane> fitOneSidedPlanes(const Sites& sites, const CreaseOptions& options,
                                             const Progress* progress = nullptr);

/// Neighbors that one-sided planes need at a noise given in mean spacings: 48 to 200.
int creaseNeighbors(double noise);

/// Angle in [0, pi] by which the surface turns from one plane to the other: 0 where they are one, pi - t at a
/// blade of opening t. By the angles of the line between the centers with both planes, so that no orientation
/// is needed.
double turningAngle(const OneSidedPlane& a, const OneSidedPlane& b);

/// Turning from which an edge is blocked so that a crease of `creaseAngle` is sealed. Noise only lowers the
/// turning that is seen across a crease; the allowance of 12 degrees pays for that (a third of small angles).
double blockingTurn(double creaseAngle);

}  // namespace stipple
