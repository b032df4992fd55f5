#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/moments.h"

namespace stipple {

namespace {

struct LocalFit {
  double residual;  // standard deviation off the quadric, in length
  double spacing;   // sqrt(area of the neighborhood / its points)
};

// Least squares of the height over the tangent plane by a full quadric (6 coefficients).
std::optional<LocalFit> fitQuadric(const Sites& sites, Index site, std::span<const Index> neighbors, double radius) {
  const auto count = static_cast<Eigen::Index>(neighbors.size()) + 1;
  if (count < 10 || !(radius > 0)) return std::nullopt;
  Eigen::MatrixX3d d(count, 3);
  d.row(0).setZero();
  for (Eigen::Index r = 1; r < count; ++r) {
    d.row(r) = (sites.positions[neighbors[static_cast<std::size_t>(r - 1)]] - sites.positions[site])
                   .cast<double>()
                   .transpose() /
               radius;
  }
  const Eigen::RowVector3d center = d.colwise().mean();
  d.rowwise() -= center;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> frame(d.transpose() * d);
  const Eigen::VectorXd u = d * frame.eigenvectors().col(2), v = d * frame.eigenvectors().col(1),
                        height = d * frame.eigenvectors().col(0);
  Eigen::MatrixXd terms(count, 6);
  terms << Eigen::VectorXd::Ones(count), u, v, u.cwiseProduct(u), u.cwiseProduct(v), v.cwiseProduct(v);
  const Eigen::VectorXd residual = height - terms * terms.colPivHouseholderQr().solve(height);
  const double variance = residual.squaredNorm() / static_cast<double>(count - 6);
  return LocalFit{std::sqrt(variance) * radius, radius * std::sqrt(3.14159265358979 / static_cast<double>(count))};
}

}  // namespace

double estimateNoise(const Sites& sites, int k) {
  // A few thousand sites spread over the Morton order give the median to a few percent.
  const Index samples = std::min<Index>(sites.size(), 4000);
  if (samples < 10) return 0;
  const NeighborSearch search(sites.positions, k);
  std::vector<double> ratios(samples, -1.0);
  parallelFor(samples, 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> neighbors;
    std::vector<float> squared;
    for (std::size_t s = begin; s < end; ++s) {
      const auto site = static_cast<Index>(s * sites.size() / samples);
      search.findNearest(site, k, neighbors, squared);
      if (neighbors.empty()) continue;
      const auto fit = fitQuadric(sites, site, neighbors, std::sqrt(static_cast<double>(squared.back())));
      if (fit) ratios[s] = fit->residual / fit->spacing;
    }
  });
  std::erase_if(ratios, [](double ratio) { return ratio < 0; });
  if (ratios.empty()) return 0;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

}  // namespace stipple
