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
constexpr int kRings = 7;
// Light that is too faint to compare: colors near black differ by noise and by rounding.
constexpr double kFaint = 0.01;
// A relief that varies by less than this (root of it: radians, spacings) tells nothing.
constexpr double kLeastDifference = 1e-4;
constexpr double kLeastSquare = 1e-12;  // of what is left of a log
// Share of what differences explain that the estimate from values has to explain of them, to be kept. Paint
// may change with the shape over a part by chance, but not from neighbor to neighbor too.
constexpr double kBorneOut = 0.2;
// What squared differences along edges (with the weights of the stiffness) may count beside squared values,
// and the mean of log(1 + count x) over the eigenvalues x of the stiffness of an even hexagonal lattice: the
// log determinant for each site. What does not follow the relief (the paint) may be a grain, or alike
// over many spacings; a patch of paint must not be taken for light.
struct Edges {
  double count, logDeterminant;
};
constexpr Edges kEdges[] = {{1, 1.424}, {4, 2.572}, {16, 3.876}, {64, 5.236}, {256, 6.614}, {4096, 9.385}};
// Columns of what is compared: trend, relief, logs of the channels.
constexpr int kTrend = 4, kCoefficients = kTrend + kReliefSize;
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

// What is compared at a site: 1 and its place (the trend), its relief, the logs of its channels.
class Columns {
 public:
  using Row = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kCoefficients + 4, 1>;

  Columns(const Sites& sites, const Part& part, const Relief& relief, const Eigen::MatrixXd& logs)
      : sites_(sites), relief_(relief), logs_(logs) {
    for (const Index site : part.known) middle_ += placeOf(site) / static_cast<double>(part.known.size());
    double squares = 0;
    for (const Index site : part.known) squares += (placeOf(site) - middle_).squaredNorm();
    scale_ = std::sqrt(static_cast<double>(part.known.size()) / squares);
  }
  Row operator()(Index site) const {
    Row row(kCoefficients + logs_.cols());
    row << 1, scale_ * (placeOf(site) - middle_), relief_.row(site).transpose(), logs_.row(site).transpose();
    return row;
  }

 private:
  Eigen::Vector3d placeOf(Index site) const { return sites_.positions[site].cast<double>(); }

  const Sites& sites_;
  const Relief& relief_;
  const Eigen::MatrixXd& logs_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  double scale_;
};

// Sums of products of the columns over the known sites of a part, and of their differences over edges.
using Gram = Eigen::MatrixXd;
struct Grams {
  Gram values, edges;
};
Grams compare(const Discretization& d, const Part& part, const std::vector<std::uint8_t>& isKnown,
              const Relief& relief, const Eigen::MatrixXd& logs) {
  const Columns columns(d.sites, part, relief, logs);
  Gram values = Gram::Zero(kCoefficients + logs.cols(), kCoefficients + logs.cols()), edges = values;
  for (const Index i : part.known) {
    const Columns::Row own = columns(i);
    values.selfadjointView<Eigen::Lower>().rankUpdate(own);
    for (Index e = d.fans.offsets[i]; e < d.fans.offsets[i + 1]; ++e) {
      const Index j = d.fans.neighbors[e];
      const double weight = std::max(0.0, d.weights[e]) / 2;  // every edge is met twice
      if (!isKnown[j] || weight == 0) continue;
      const Columns::Row difference = own - columns(j);
      edges.selfadjointView<Eigen::Lower>().rankUpdate(difference, weight);
    }
  }
  return {values.selfadjointView<Eigen::Lower>(), edges.selfadjointView<Eigen::Lower>()};
}

struct Fit {
  Eigen::MatrixXd matrix, right;   // of the normal equations
  Eigen::MatrixXd coefficients;    // columns are channels
  Eigen::ArrayXd explained, left;  // of the squares of each channel
};

Eigen::ArrayXd explainedBy(const Eigen::MatrixXd& coefficients, const Fit& fit) {
  return coefficients.cwiseProduct(2 * fit.right - fit.matrix * coefficients).colwise().sum().transpose();
}

Fit fit(const Gram& gram, double count) {
  const Eigen::Index rest = gram.cols() - kTrend, channels = gram.cols() - kCoefficients;
  Eigen::Matrix4d trend = gram.topLeftCorner<kTrend, kTrend>();
  trend.diagonal().array() += 1e-9 * count;  // parts may lie in a plane
  const Gram detrended =
      gram.bottomRightCorner(rest, rest) -
      gram.bottomLeftCorner(rest, kTrend) * trend.ldlt().solve(gram.topRightCorner(kTrend, rest));
  Eigen::MatrixXd matrix = detrended.topLeftCorner<kReliefSize, kReliefSize>();
  matrix.diagonal().array() += kLeastDifference * count;
  const Eigen::MatrixXd right = detrended.topRightCorner(kReliefSize, channels);
  Fit result{.matrix = matrix,
             .right = right,
             .coefficients = matrix.ldlt().solve(right),
             .explained = {},
             .left = {}};
  result.explained = explainedBy(result.coefficients, result);
  result.left = detrended.diagonal().tail(channels).array() - result.explained;
  return result;
}

// By the first model of the paint where the likeliest one bears it out, else by that (Gaussian, its precision
// that of values and edges). Columns are channels, 0 where the relief explains no more than it would by
// chance.
Eigen::MatrixXd coefficientsOf(const Grams& grams, double count) {
  const Fit first = fit(grams.values + kEdges[0].count * grams.edges, count);
  Fit best = first;
  double least = std::numeric_limits<double>::infinity();
  for (const Edges& edges : kEdges) {
    Fit next = fit(grams.values + edges.count * grams.edges, count);
    const double surprise = (next.left.max(kLeastSquare * count).log() - edges.logDeterminant).sum();
    if (!(surprise < least)) continue;
    least = surprise;
    best = std::move(next);
  }
  if (explainedBy(first.coefficients, best).sum() > kBorneOut * best.explained.sum()) best = first;
  for (Eigen::Index c = 0; c < best.coefficients.cols(); ++c) {
    const double byChance = std::max(0.0, kReliefSize * best.left[c] / (count - kCoefficients));
    if (best.explained[c] > byChance)
      best.coefficients.col(c) *= 1 - byChance / best.explained[c];
    else
      best.coefficients.col(c).setZero();
  }
  return best.coefficients;
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
    if (part.known.size() <= 2 * kCoefficients) continue;
    const Grams grams = compare(d, part, isKnown, relief, logs);
    writeFactors(part, relief, coefficientsOf(grams, static_cast<double>(part.known.size())), factors_);
  }
}

void Shading::takeOff(Eigen::MatrixXd& colors) const {
  if (factors_.size() > 0) colors = (colors.array() + kFaint) / factors_.array() - kFaint;
}

void Shading::putOn(Eigen::MatrixXd& colors) const {
  if (factors_.size() > 0) colors = (colors.array() + kFaint) * factors_.array() - kFaint;
}

}  // namespace stipple
