#include "plugins/segmentation/label_growth.h"

#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

// K acts in full where u > theta: implicit diffusion makes u > 0 everywhere at once. It rises linearly from a
// tenth of theta, so that labels depend continuously on u: with a jump at theta, the last digit of u decides
// whether a front passes a bottleneck one step earlier.
constexpr double kTheta = 0.01;
constexpr double kOnset = 0.1 * kTheta;
// The rate alpha of K times the time step: u runs to 1 in a few steps, whatever the unit of length.
constexpr double kRateTimesStep = 0.5;

// K(u) times the time step.
double reaction(double u) {
  if (!(u > kOnset && u < 1)) return 0;
  return kRateTimesStep * std::sqrt(1 - u) * std::min(1.0, (u - kOnset) / (kTheta - kOnset));
}

SparseMatrix extractPiece(const Pieces& pieces, Index piece, const SparseMatrix& stiffness) {
  const std::span<const Index> sites = pieces.of(piece);
  SparseMatrix part(sites.size(), sites.size());
  Eigen::Index entries = 0;
  for (const Index site : sites)
    entries += stiffness.outerIndexPtr()[site + 1] - stiffness.outerIndexPtr()[site];
  part.reserve(entries);
  for (std::size_t rank = 0; rank < sites.size(); ++rank) {
    part.startVec(rank);
    for (SparseMatrix::InnerIterator entry(stiffness, sites[rank]); entry; ++entry) {
      if (pieces.pieceOfSite[entry.col()] == piece)
        part.insertBack(rank, pieces.rankOfSite[entry.col()]) = entry.value();
    }
  }
  part.finalize();
  return part;
}

DiffusionStepper makeStepper(const Pieces& pieces, Index piece, const SparseMatrix& stiffness,
                             std::span<const double> mass, std::span<const Index> held,
                             const GrowthOptions& options, const Progress* progress) {
  std::vector<double> pieceMass;
  for (const Index site : pieces.of(piece)) pieceMass.push_back(mass[site]);
  DiffusionOptions diffusion = {.timeStep = options.timeStep, .held = {}, .solver = options.solver};
  for (const Index site : held) diffusion.held.push_back(pieces.rankOfSite[site]);
  return DiffusionStepper(extractPiece(pieces, piece, stiffness), pieceMass, diffusion, progress);
}

}  // namespace

LabelGrowth::LabelGrowth(const Pieces& pieces, Index piece, const SparseMatrix& stiffness,
                         std::span<const double> mass, std::span<const Index> held,
                         const GrowthOptions& options, const Progress* progress)
    : sites_(pieces.of(piece).begin(), pieces.of(piece).end()),
      pieces_(pieces),
      stepper_(makeStepper(pieces, piece, stiffness, mass, held, options, progress)),
      u_(sites_.size(), 0) {}

void LabelGrowth::plant(std::int32_t label, std::span<const Index> sites, Labeling& labeling) {
  const auto column = static_cast<Index>(labels_.size());
  labels_.push_back(label);
  u_.conservativeResize(Eigen::NoChange, column + 1);
  u_.col(column).setZero();
  for (const Index site : sites) {
    const Index rank = pieces_.rankOfSite[site];
    seeds_.push_back({rank, column});
    u_(rank, column) = 1;
    labeling.labels[site] = label;
    labeling.signal[site] = 1;
  }
  taken_ += static_cast<Index>(sites.size());
}

void LabelGrowth::clear() {
  u_.resize(sites_.size(), 0);
  labels_.clear();
  seeds_.clear();
  taken_ = 0;
}

bool LabelGrowth::react(Index rank, double threshold, Labeling& labeling) {
  const Index site = sites_[rank];
  std::int32_t& owner = labeling.labels[site];
  double strongest = 0;
  std::size_t winner = 0;
  for (std::size_t c = 0; c < labels_.size(); ++c) {
    double& u = u_(rank, c);
    if (owner != 0 && owner != labels_[c]) u = 0;
    u = std::clamp(u + reaction(u), 0.0, 1.0);
    if (u > strongest) {
      strongest = u;
      winner = c;
    }
  }
  const bool isTaken = owner == 0 && strongest > threshold;
  if (isTaken) {
    owner = labels_[winner];
    for (std::size_t c = 0; c < labels_.size(); ++c) {
      if (c != winner) u_(rank, c) = 0;
    }
  }
  const bool isOurs = owner != 0 && std::find(labels_.begin(), labels_.end(), owner) != labels_.end();
  if (isOurs) labeling.signal[site] = static_cast<float>(strongest);
  if (owner == 0) labeling.signal[site] = std::max(labeling.signal[site], static_cast<float>(strongest));
  return isTaken;
}

Index LabelGrowth::step(double threshold, Labeling& labeling, const Progress* progress) {
  stepper_.step(u_, progress);
  const double count = parallelSum(sites_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    double taken = 0;
    for (auto rank = static_cast<Index>(begin); rank < end; ++rank)
      taken += react(rank, threshold, labeling) ? 1 : 0;
    return taken;
  });
  for (const Seed& seed : seeds_) {
    u_(seed.rank, seed.column) = 1;
    labeling.signal[sites_[seed.rank]] = 1;
  }
  taken_ += static_cast<Index>(count);
  return static_cast<Index>(count);
}

}  // namespace stipple
