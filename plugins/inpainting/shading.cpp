#include "plugins/inpainting/shading.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/site_sets.h"
#include "plugins/inpainting/relief.h"

namespace stipple {

namespace {

// How far around a part of the mask colors are compared with the relief, in fans: about as many spacings.
constexpr int kRings = 7;
// Light that is too faint to compare: colors near black differ by noise and by rounding.
constexpr double kFaint = 0.01;
// A relief that varies by less than this (root of it: radians, spacings) tells nothing.
constexpr double kLeastDifference = 1e-4;
// Of the relief and of the trend.
constexpr int kCoefficients = kReliefSize + 4;
constexpr double kLeastCorrelation = 1e-3, kMostCorrelation = 0.98;
constexpr Index kFar = std::numeric_limits<Index>::max();

// Sites of one part of the mask and around it.
struct Part {
  std::vector<Index> known, unknown;
};
// Neighbors that are near a mask are near the same part of it.
struct Parts {
  std::vector<Part> parts;
  std::vector<Index> placeOf;  // of sites among the known of their part; else kFar
};

Parts partsAround(const Hole& hole) {
  const Fans& fans = hole.discretization.fans;
  std::vector<Index> reached(hole.unknown), rings(fans.size(), kFar);
  for (const Index site : hole.unknown) rings[site] = 0;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const Index site = reached[next];
    if (rings[site] == kRings) break;
    for (const Index neighbor : fans.of(site)) {
      if (rings[neighbor] != kFar) continue;
      rings[neighbor] = rings[site] + 1;
      reached.push_back(neighbor);
    }
  }
  SiteSets sets(fans.size());
  for (const Index site : reached) {
    for (const Index neighbor : fans.of(site)) {
      if (rings[neighbor] != kFar) sets.join(site, neighbor);
    }
  }
  Parts result{.parts = {}, .placeOf = std::vector<Index>(fans.size(), kFar)};
  std::vector<Index> partOfRoot(fans.size(), kFar);
  for (const Index site : reached) {
    Index& number = partOfRoot[sets.rootOf(site)];
    if (number == kFar) {
      number = static_cast<Index>(result.parts.size());
      result.parts.emplace_back();
    }
    Part& part = result.parts[number];
    if (rings[site] > 0) result.placeOf[site] = static_cast<Index>(part.known.size());
    (rings[site] == 0 ? part.unknown : part.known).push_back(site);
  }
  return result;
}

// Relief, log of the colors and neither's trend over the known sites of one part.
struct Samples {
  Eigen::MatrixXd relief, logs;
};

// Least squares leave the trend out: the fill continues what changes evenly over the whole part.
void removeTrend(const Discretization& d, const Part& part, Samples& samples) {
  const auto count = static_cast<Eigen::Index>(part.known.size());
  Eigen::Matrix<double, Eigen::Dynamic, 4> trend(count, 4);
  trend.col(0).setOnes();
  for (Eigen::Index k = 0; k < count; ++k)
    trend.row(k).tail<3>() = d.sites.positions[part.known[static_cast<std::size_t>(k)]].cast<double>();
  trend.rightCols<3>().rowwise() -= trend.rightCols<3>().colwise().mean().eval();
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, 4>> factors(trend);
  samples.relief -= trend * factors.solve(samples.relief);
  samples.logs -= trend * factors.solve(samples.logs);
}

// How many of the samples tell as much as one that stands for itself: what is left of a channel fades with
// the distance as r^steps, r its correlation between neighbors; summed over the plane.
Eigen::RowVectorXd sharingOf(const Fans& fans, const Part& part, std::span<const Index> placeOf,
                             const Eigen::MatrixXd& left) {
  Eigen::RowVectorXd products = Eigen::RowVectorXd::Zero(left.cols()), squares = products;
  for (std::size_t k = 0; k < part.known.size(); ++k) {
    const auto own = left.row(static_cast<Eigen::Index>(k));
    for (const Index neighbor : fans.of(part.known[k])) {
      if (placeOf[neighbor] == kFar) continue;
      products += own.cwiseProduct(left.row(placeOf[neighbor]));
      squares += own.cwiseAbs2();
    }
  }
  Eigen::RowVectorXd sharing(left.cols());
  for (Eigen::Index c = 0; c < left.cols(); ++c) {
    const double r = squares[c] > 0
                         ? std::clamp(products[c] / squares[c], kLeastCorrelation, kMostCorrelation)
                         : kLeastCorrelation;
    sharing[c] = 1 + 2 * std::numbers::pi / std::pow(std::log(r), 2);
  }
  return sharing;
}

// Columns are channels; 0 where the relief explains no more than it would by chance.
Eigen::MatrixXd coefficientsOf(const Discretization& d, const Part& part, std::span<const Index> placeOf,
                               const Relief& relief, const Eigen::MatrixXd& logs) {
  const auto count = static_cast<double>(part.known.size());
  Samples samples{relief(part.known, Eigen::all), logs(part.known, Eigen::all)};
  removeTrend(d, part, samples);
  Eigen::MatrixXd matrix = samples.relief.transpose() * samples.relief;
  matrix.diagonal().array() += kLeastDifference * count;
  const Eigen::MatrixXd right = samples.relief.transpose() * samples.logs;
  Eigen::MatrixXd coefficients = matrix.ldlt().solve(right);
  const Eigen::MatrixXd left = samples.logs - samples.relief * coefficients;
  const Eigen::RowVectorXd sharing = sharingOf(d.fans, part, placeOf, left);
  for (Eigen::Index c = 0; c < coefficients.cols(); ++c) {
    const double explained = coefficients.col(c).dot(right.col(c));
    const double byChance = kReliefSize * sharing[c] * left.col(c).squaredNorm() / (count - kCoefficients);
    const bool isMore = std::isfinite(explained) && explained > byChance;
    coefficients.col(c) *= isMore ? 1 - byChance / explained : 0;
  }
  return coefficients;
}

// log s of the rows; inside no brighter or darker than around, and 0 in the mean there.
void writeFactors(const Part& part, const Relief& relief, const Eigen::MatrixXd& coefficients,
                  Eigen::MatrixXd& factors) {
  const auto lightOf = [&](Index site) { return (relief.row(site) * coefficients).eval(); };
  Eigen::MatrixXd known(part.known.size(), coefficients.cols());
  for (std::size_t k = 0; k < part.known.size(); ++k)
    known.row(static_cast<Eigen::Index>(k)) = lightOf(part.known[k]);
  const Eigen::RowVectorXd least = known.colwise().minCoeff(), most = known.colwise().maxCoeff(),
                           mean = known.colwise().mean();
  for (const Index site : part.known) factors.row(site) = (lightOf(site) - mean).array().exp();
  for (const Index site : part.unknown)
    factors.row(site) = (lightOf(site).cwiseMax(least).cwiseMin(most) - mean).array().exp();
}

}  // namespace

Shading::Shading(const Hole& hole, const Progress* progress) {
  const Discretization& d = hole.discretization;
  if (!hole.isLight || hole.unknown.empty()) return;
  const Relief relief = describeRelief(d, progress);
  if (!relief.allFinite()) return;
  const Eigen::MatrixXd logs = (hole.values.array() + kFaint).log();
  factors_.setOnes(hole.values.rows(), hole.values.cols());
  const Parts around = partsAround(hole);
  for (const Part& part : around.parts) {
    // Twice as many as there are unknown coefficients: fewer tell nothing.
    if (part.known.size() > 2 * kCoefficients)
      writeFactors(part, relief, coefficientsOf(d, part, around.placeOf, relief, logs), factors_);
  }
}

void Shading::takeOff(Eigen::MatrixXd& colors) const {
  if (factors_.size() > 0) colors = (colors.array() + kFaint) / factors_.array() - kFaint;
}

void Shading::putOn(Eigen::MatrixXd& colors) const {
  if (factors_.size() > 0) colors = (colors.array() + kFaint) * factors_.array() - kFaint;
}

}  // namespace stipple
