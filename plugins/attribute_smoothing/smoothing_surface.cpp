#include "plugins/attribute_smoothing/smoothing_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/fem/gradient.h"
#include "core/geometry/creases.h"
#include "core/geometry/moments.h"
#include "core/points/field.h"

namespace stipple {

namespace {

constexpr double kCreaseAngle = std::numbers::pi / 4;
// The noise is that of 16 neighbors: with more, the curvature of coarse scans counts as noise.
constexpr int kNoiseNeighbors = 16;
// Gradients above this quantile are edges.
constexpr double kEdgeQuantile = 0.875;

// Squared gradient, summed over channels, averaged over the fan of each site: noise of single points is no
// edge (Catte et al. 1992).
std::vector<double> squaredGradients(const Discretization& d, const Eigen::MatrixXd& values,
                                     const Progress& progress) {
  std::vector<double> squared(d.size(), 0.0), channel(d.size());
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    Eigen::VectorXd::Map(channel.data(), values.rows()) = values.col(c);
    const std::vector<Eigen::Vector3d> gradients = fanGradient(d, channel, &progress);
    for (Index i = 0; i < d.size(); ++i) squared[i] += gradients[i].squaredNorm();
  }
  std::vector<double> means = squared;
  for (Index i = 0; i < d.size(); ++i) {
    for (const Index j : d.fans.of(i)) means[i] += squared[j];
    means[i] /= static_cast<double>(d.fans.of(i).size() + 1);
  }
  return means;
}

}  // namespace

SmoothingSurface::SmoothingSurface(const PointSet& points, const Attribute& attribute, const Region& region,
                                   const DiscretizationOptions& options, Progress& progress)
    : discretization_(discretize(points, options, progress)) {
  const Sites& sites = discretization_.sites;
  squaredSpacing_ = std::accumulate(discretization_.mass.begin(), discretization_.mass.end(), 0.0) /
                    std::max<double>(sites.size(), 1);
  givenValues_ = readField(attribute, sites.pointOfSite);
  isFinite_.assign(sites.size(), 1);
  for (Index site = 0; site < sites.size(); ++site) {
    if (givenValues_.row(site).allFinite()) continue;
    givenValues_.row(site).setZero();
    isFinite_[site] = 0;
    allFinite_ = false;
  }
  std::vector<std::uint8_t> isHeld(sites.size(), 0);
  for (Index row = 0; row < points.size(); ++row) {
    const Index site = sites.siteOfPoint[row];
    if (!region.contains(row)) {
      isHeld[site] = 1;
    } else if (isFinite_[site] && readField(attribute, {&row, 1}).allFinite()) {
      writtenRows_.push_back(row);
    }
  }
  for (Index site = 0; site < sites.size(); ++site) {
    if (isHeld[site]) heldSites_.push_back(site);
  }
}

SparseMatrix SmoothingSurface::stiffness(bool blocksCreases, const Progress& progress) {
  if (!blocksCreases && allFinite_) {
    SparseMatrix stiffness = assembleStiffness(discretization_, &progress);
    // The cotangents of whole triangles are semidefinite; the fans of scheme paper, which do not agree, are
    // not.
    if (discretization_.options.scheme == Scheme::kPaper) dropNegativeWeights(stiffness);
    return stiffness;
  }
  return stiffnessTimes(std::vector<double>(discretization_.size(), 1.0), blocksCreases, progress);
}

SparseMatrix SmoothingSurface::edgePreservingStiffness(const Eigen::MatrixXd& values, bool blocksCreases,
                                                       const Progress& progress) {
  std::vector<double> diffusivity = squaredGradients(discretization_, values, progress);
  std::vector<double> sorted = diffusivity;
  const auto place =
      sorted.begin() + static_cast<std::ptrdiff_t>(kEdgeQuantile * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), place, sorted.end());
  const double contrast = *place;
  for (double& a : diffusivity) a = contrast > 0 ? std::exp(-a / contrast) : (a > 0 ? 0.0 : 1.0);
  return stiffnessTimes(diffusivity, blocksCreases, progress);
}

SparseMatrix SmoothingSurface::stiffnessTimes(const std::vector<double>& a, bool blocksCreases,
                                              const Progress& progress) {
  if (blocksCreases && planes_.empty()) {
    const double noise = estimateNoise(discretization_.sites, kNoiseNeighbors);
    planes_ =
        fitOneSidedPlanes(discretization_.sites, {.k = creaseNeighbors(noise), .noise = noise}, &progress);
  }
  const double turn = blockingTurn(kCreaseAngle);
  const auto factor = [&](Index i, Index j) {
    if (!isFinite_[i] || !isFinite_[j]) return 0.0;
    if (blocksCreases && turningAngle(planes_[std::min(i, j)], planes_[std::max(i, j)]) > turn) return 0.0;
    return a[i] + a[j] > 0 ? 2 * a[i] * a[j] / (a[i] + a[j]) : 0.0;
  };
  SparseMatrix stiffness = assembleStiffness(discretization_, factor, &progress);
  // Weights below 0 no longer cancel where the factors of a triangle differ: the values would run apart.
  dropNegativeWeights(stiffness);
  return stiffness;
}

}  // namespace stipple
