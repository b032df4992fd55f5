#include "plugins/texture_synthesis/pair_diffusion.h"

#include <cmath>

#include "core/error.h"

namespace stipple {

namespace {

constexpr std::size_t kBlock = 4096;
// The residual of a step falls to this share, and what is left acts in the next step: patterns have the same
// number of spots within 1 % from 3e-2 to 1e-4. A bound relative to the values themselves would stop slow
// growth.
constexpr double kTolerance = 1e-2;
constexpr int kMostIterations = 400;

}  // namespace

PairDiffusion::PairDiffusion(const SparseMatrix& stiffness, std::span<const double> mass, double spacing)
    : squaredSpacing_(spacing * spacing) {
  const auto rows = static_cast<std::size_t>(stiffness.rows());
  offsets_.reserve(rows + 1);
  offsets_.push_back(0);
  for (std::size_t row = 0; row < rows; ++row) {
    double diagonal = 0;
    for (SparseMatrix::InnerIterator entry(stiffness, static_cast<Eigen::Index>(row)); entry; ++entry) {
      if (static_cast<std::size_t>(entry.col()) == row || entry.value() == 0) continue;
      columns_.push_back(static_cast<Index>(entry.col()));
      weights_.push_back(static_cast<float>(-entry.value()));
      diagonal -= entry.value();
    }
    offsets_.push_back(static_cast<Index>(columns_.size()));
    diagonal_.push_back(static_cast<float>(std::max(diagonal, 0.0)));
    mass_.push_back(static_cast<float>(mass[row] / squaredSpacing_));
  }
  residual_.resize(rows);
  direction_.resize(rows);
  image_.resize(rows);
  inverse_.resize(rows);
  partial_.resize((rows + kBlock - 1) / kBlock);
}

template <class Block>
PairDiffusion::PairSum PairDiffusion::sumBlocks(const Block& block) {
  parallelFor(mass_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    partial_[begin / kBlock] = block(static_cast<Index>(begin), static_cast<Index>(end));
  });
  PairSum sum{};
  for (const PairSum& part : partial_) {
    sum[0] += part[0];
    sum[1] += part[1];
  }
  return sum;
}

// L u at a row; differences first, so that no digits go in constants.
inline Pair PairDiffusion::spread(Index row, const Pair* values) const {
  const Pair own = values[row];
  Pair sum = Pair::Zero();
  for (Index e = offsets_[row]; e < offsets_[row + 1]; ++e) sum += weights_[e] * (own - values[columns_[e]]);
  return sum;
}

PairDiffusion::PairSum PairDiffusion::findResidual(const Scaled& terms, std::span<const Pair> right,
                                                   std::span<const Pair> u) {
  return sumBlocks([&](Index begin, Index end) {
    Eigen::Array2d sum = Eigen::Array2d::Zero();
    for (Index i = begin; i < end; ++i) {
      inverse_[i] = (terms.mass * mass_[i] + terms.stiffness * diagonal_[i]).inverse();
      residual_[i] = mass_[i] * (right[i] - terms.mass * u[i]) - terms.stiffness * spread(i, u.data());
      direction_[i] = residual_[i] * inverse_[i];
      sum += (residual_[i] * direction_[i]).cast<double>();
    }
    return PairSum{sum[0], sum[1]};
  });
}

PairDiffusion::PairSum PairDiffusion::applyToDirection(const Scaled& terms) {
  return sumBlocks([&](Index begin, Index end) {
    Eigen::Array2d sum = Eigen::Array2d::Zero();
    for (Index i = begin; i < end; ++i) {
      image_[i] = mass_[i] * terms.mass * direction_[i] + terms.stiffness * spread(i, direction_.data());
      sum += (image_[i] * direction_[i]).cast<double>();
    }
    return PairSum{sum[0], sum[1]};
  });
}

PairDiffusion::PairSum PairDiffusion::advance(const Pair& alpha, std::span<Pair> u) {
  return sumBlocks([&](Index begin, Index end) {
    Eigen::Array2d sum = Eigen::Array2d::Zero();
    for (Index i = begin; i < end; ++i) {
      u[i] += alpha * direction_[i];
      residual_[i] -= alpha * image_[i];
      sum += (residual_[i] * residual_[i] * inverse_[i]).cast<double>();
    }
    return PairSum{sum[0], sum[1]};
  });
}

void PairDiffusion::turnDirection(const Pair& beta) {
  parallelFor(mass_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      direction_[i] = residual_[i] * inverse_[i] + beta * direction_[i];
    }
  });
}

int PairDiffusion::solve(const PairTerms& terms, std::span<const Pair> right, std::span<Pair> u) {
  const Scaled scaled{
      .mass = Eigen::Array2d(terms.mass[0], terms.mass[1]).cast<float>(),
      .stiffness = (Eigen::Array2d(terms.stiffness[0], terms.stiffness[1]) / squaredSpacing_).cast<float>()};
  PairSum energy = findResidual(scaled, right, u);
  if (!std::isfinite(energy[0] + energy[1])) throw SolverError("the concentrations grew beyond all bounds");
  const PairSum enough = {energy[0] * kTolerance * kTolerance, energy[1] * kTolerance * kTolerance};
  int iterations = 0;
  while ((energy[0] > enough[0] || energy[1] > enough[1]) && iterations < kMostIterations) {
    const PairSum curvature = applyToDirection(scaled);
    Pair alpha = Pair::Zero(), beta = Pair::Zero();
    for (std::size_t lane = 0; lane < 2; ++lane) {
      // A species that is done rests while the other goes on.
      if (energy[lane] <= enough[lane] || !(curvature[lane] > 0)) continue;
      alpha[static_cast<Eigen::Index>(lane)] = static_cast<float>(energy[lane] / curvature[lane]);
    }
    const PairSum next = advance(alpha, u);
    ++iterations;
    for (std::size_t lane = 0; lane < 2; ++lane) {
      if (energy[lane] > 0)
        beta[static_cast<Eigen::Index>(lane)] = static_cast<float>(next[lane] / energy[lane]);
    }
    energy = next;
    if (energy[0] > enough[0] || energy[1] > enough[1]) turnDirection(beta);
  }
  return iterations;
}

}  // namespace stipple
