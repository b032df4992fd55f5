#include "plugins/inpainting/shading.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/site_sets.h"
#include "plugins/inpainting/relief.h"

namespace stipple {

namespace {

// How far around a part of the mask colors are compared with the relief, in fans: about as many spacings.
constexpr int kRings = 10;
// Light that is too faint to compare: colors near black differ by noise and by rounding.
constexpr double kFaint = 0.01;
// Neighbors whose relief differs by less than this (root of it: radians, spacings) tell nothing.
constexpr double kLeastDifference = 1e-5;
constexpr Index kFar = std::numeric_limits<Index>::max();

// Sites of one part of the mask and around it.
struct Part {
  std::vector<Index> known, unknown;
};

std::vector<Part> partsAround(const Hole& hole) {
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
  std::vector<Part> parts;
  std::vector<Index> partOfRoot(fans.size(), kFar);
  for (const Index site : reached) {
    Index& part = partOfRoot[sets.rootOf(site)];
    if (part == kFar) {
      part = static_cast<Index>(parts.size());
      parts.emplace_back();
    }
    (rings[site] == 0 ? parts[part].unknown : parts[part].known).push_back(site);
  }
  return parts;
}

// The least squares of one part, edge by edge with the weights of the stiffness.
struct NormalEquations {
  Eigen::Matrix<double, kReliefSize, kReliefSize> matrix;
  Eigen::Matrix<double, kReliefSize, Eigen::Dynamic> right;
  Eigen::RowVectorXd energy;  // of log u, each channel
  double weight = 0;
};

NormalEquations compare(const Discretization& d, const Part& part, const Relief& relief,
                        const Eigen::MatrixXd& logs, const std::vector<std::uint8_t>& isKnown) {
  NormalEquations sums;
  sums.matrix.setZero();
  sums.right.setZero(kReliefSize, logs.cols());
  sums.energy.setZero(logs.cols());
  for (const Index i : part.known) {
    for (Index e = d.fans.offsets[i]; e < d.fans.offsets[i + 1]; ++e) {
      const Index j = d.fans.neighbors[e];
      const double weight = std::max(0.0, d.weights[e]);
      if (!isKnown[j] || weight == 0) continue;
      const Eigen::Matrix<double, kReliefSize, 1> shape = (relief.row(i) - relief.row(j)).transpose();
      const Eigen::RowVectorXd color = logs.row(i) - logs.row(j);
      sums.matrix.noalias() += weight * shape * shape.transpose();
      sums.right.noalias() += weight * shape * color;
      sums.energy += weight * color.cwiseAbs2();
      sums.weight += weight;
    }
  }
  return sums;
}

// Columns are channels; 0 where the relief explains no more than it would by chance.
Eigen::MatrixXd coefficientsOf(const NormalEquations& sums, std::size_t known) {
  Eigen::Matrix<double, kReliefSize, kReliefSize> matrix = sums.matrix;
  matrix.diagonal().array() += kLeastDifference * sums.weight;
  Eigen::MatrixXd coefficients = matrix.ldlt().solve(sums.right);
  for (Eigen::Index c = 0; c < coefficients.cols(); ++c) {
    const double explained = coefficients.col(c).dot(sums.right.col(c));
    const double byChance =
        kReliefSize * (sums.energy[c] - explained) / static_cast<double>(known - kReliefSize);
    const bool isMore = std::isfinite(explained) && explained > std::max(0.0, byChance);
    coefficients.col(c) *= isMore ? 1 - std::max(0.0, byChance) / explained : 0;
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
  std::vector<std::uint8_t> isKnown(d.size(), 1);
  for (const Index site : hole.unknown) isKnown[site] = 0;
  const Relief relief = describeRelief(d, progress);
  if (!relief.allFinite()) return;
  const Eigen::MatrixXd logs = (hole.values.array() + kFaint).log();
  factors_.setOnes(hole.values.rows(), hole.values.cols());
  for (const Part& part : partsAround(hole)) {
    // Twice as many as there are unknown coefficients: fewer tell nothing.
    if (part.known.size() <= 2 * kReliefSize) continue;
    const NormalEquations sums = compare(d, part, relief, logs, isKnown);
    if (!(sums.weight > 0)) continue;
    writeFactors(part, relief, coefficientsOf(sums, part.known.size()), factors_);
  }
}

void Shading::takeOff(Eigen::MatrixXd& colors) const {
  if (factors_.size() > 0) colors = (colors.array() + kFaint) / factors_.array() - kFaint;
}

void Shading::putOn(Eigen::MatrixXd& colors) const {
  if (factors_.size() > 0) colors = (colors.array() + kFaint) * factors_.array() - kFaint;
}

}  // namespace stipple
