#include "core/geometry/creases.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/local_moments.h"
#include "core/geometry/neighborhoods.h"

namespace stipple {

namespace {

// Two of a hundred of the spacing count as flat: below that, rounding and slight curvature decide nothing.
constexpr float kFlatness = 0.02f;
// A site lies on a plane within two standard deviations of the noise.
constexpr float kNoiseDeviations = 2;
// How much a residual below that counts: enough to put a site beside a crease on its own side.
constexpr float kResidualWeight = 0.1f;
// A plane from the rim of the neighborhood must be a tenth flatter: curved pieces keep their own.
constexpr float kDistanceWeight = 0.1f;

// A plane whose points are off by more than this, in spacings, is taken for a mean of two pieces.
constexpr float kMixed = 0.06f;
constexpr int kMostNeighbors = 200;

struct FittedPlane {
  OneSidedPlane plane;
  float variance = 0;  // of the points off the plane, length^2
};

FittedPlane fitPlane(const Sites& sites, Index site, std::span<const Index> neighbors) {
  const LocalMoments local = sumMoments(sites.positions, site, neighbors);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(local.covariance);
  // Three parameters were fitted.
  const double unbiased = local.count / std::max(local.count - 3, 1.0);
  return {{sites.positions[site] + local.mean.cast<float>(), solver.eigenvectors().col(0).cast<float>()},
          static_cast<float>(unbiased * std::max(0.0, solver.eigenvalues()[0]))};
}

struct Choice {
  Index site = 0;            // whose plane
  float squaredSpacing = 0;  // of the neighborhood
};

// The flattest of the planes at hand on which the site lies.
Choice choosePlane(const Sites& sites, Index site, std::span<const Index> neighbors,
                   std::span<const float> squaredDistances, const std::vector<FittedPlane>& planes) {
  if (neighbors.empty()) return {site, 0};
  const float reach = std::max(squaredDistances.back(), std::numeric_limits<float>::min());
  const float squaredSpacing = reach * std::numbers::pi_v<float> / static_cast<float>(neighbors.size() + 1);
  const float floor = kFlatness * kFlatness * squaredSpacing;
  float flattest = planes[site].variance;
  for (const Index j : neighbors) flattest = std::min(flattest, planes[j].variance);
  const float allowed = kNoiseDeviations * kNoiseDeviations * (flattest + floor);

  const auto penaltyOf = [&](Index j, float squaredDistance) {
    const float residual = (sites.positions[site] - planes[j].plane.center).dot(planes[j].plane.normal);
    const float squared = residual * residual;
    const float misfit =
        planes[j].variance + std::max(0.f, squared - allowed) + kResidualWeight * squared + floor;
    return misfit * (1 + kDistanceWeight * squaredDistance / reach);
  };
  Index best = site;
  float least = penaltyOf(site, 0);
  for (std::size_t n = 0; n < neighbors.size(); ++n) {
    const float penalty = penaltyOf(neighbors[n], squaredDistances[n]);
    if (penalty < least) {
      least = penalty;
      best = neighbors[n];
    }
  }
  return {best, squaredSpacing};
}

}  // namespace

std::vector<OneSidedPlane> fitOneSidedPlanes(const Sites& sites, const CreaseOptions& options,
                                             const Progress* progress) {
  std::vector<FittedPlane> planes(sites.size());
  std::vector<OneSidedPlane> chosen(sites.size());
  const NeighborSearch search(sites.positions, options.k);
  forNeighborhoods(sites, search, std::max(6, options.k / 4), progress,
                   [&](Index site, std::span<const Index> neighbors, std::span<const float>) {
                     planes[site] = fitPlane(sites, site, neighbors);
                   });
  const auto noise = static_cast<float>(options.noise);
  const float mixed = kMixed * kMixed + kNoiseDeviations * kNoiseDeviations * noise * noise;
  forNeighborhoods(
      sites, search, options.k, progress,
      [&](Index site, std::span<const Index> neighbors, std::span<const float> squaredDistances) {
        Choice choice = choosePlane(sites, site, neighbors, squaredDistances, planes);
        std::vector<Index> wider;
        std::vector<float> widerDistances;
        for (int k = 2 * options.k; k <= std::min(4 * options.k, kMostNeighbors); k *= 2) {
          if (planes[choice.site].variance <= mixed * choice.squaredSpacing) break;
          search.findNearest(site, k, wider, widerDistances);
          choice = choosePlane(sites, site, wider, widerDistances, planes);
        }
        chosen[site] = planes[choice.site].plane;
      });
  return chosen;
}

int creaseNeighbors(double noise) {
  // A piece of radius r tells the sides of a crease apart where their rise within it exceeds the noise: k
  // grows with it. Measured on straight creases at a noise of 0, .1 and .3 spacings.
  return static_cast<int>(std::clamp(48 + 500 * noise, 48.0, static_cast<double>(kMostNeighbors)));
}

double turningAngle(const OneSidedPlane& a, const OneSidedPlane& b) {
  const double cosine = std::min(1.0, std::abs(static_cast<double>(a.normal.dot(b.normal))));
  const double between = std::acos(cosine);
  // In the cross section the turning is the exterior angle of the triangle that the line between the centers
  // closes: the sum of its angles with both planes.
  Eigen::Vector3d line = (b.center - a.center).cast<double>();
  const Eigen::Vector3d axis = a.normal.cast<double>().cross(b.normal.cast<double>());
  constexpr double kSureAxis = 0.17;  // below 10 degrees the direction of the crease is not known
  if (axis.norm() > kSureAxis) line -= axis * (axis.dot(line) / axis.squaredNorm());
  const double length = line.norm();
  if (!(length > 0)) return between;
  const double sum = std::asin(std::min(1.0, std::abs(line.dot(a.normal.cast<double>())) / length)) +
                     std::asin(std::min(1.0, std::abs(line.dot(b.normal.cast<double>())) / length));
  // At a blade the sum exceeds the angle between the planes, though not always by much: an angle of the
  // triangle may be obtuse. In flat places noise tilts the line.
  constexpr double kDegree = std::numbers::pi / 180;
  return sum > std::max(45 * kDegree, between + 15 * kDegree) ? std::numbers::pi - between : between;
}

double blockingTurn(double creaseAngle) {
  return creaseAngle - std::min(12 * std::numbers::pi / 180, creaseAngle / 3);
}

}  // namespace stipple
