#include "plugins/texture_synthesis/pair_diffusion.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace stipple {

namespace {

constexpr std::size_t kBlock = 4096;
// The residual of a step falls to this share, and what is left acts in the next step: patterns have the same
// number of spots within 1 % from here to 1e-4. A bound relative to the values themselves would stop slow
// growth.
constexpr double kTolerance = 3e-2;
constexpr int kMostIterations = 400;

void add(Pair value, std::array<double, 2>& sum) {
  sum[0] += static_cast<double>(value[0]);
  sum[1] += static_cast<double>(value[1]);
}

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
    if (columns_.size() % 2 != 0) {
      columns_.push_back(static_cast<Index>(row));
      weights_.push_back(0);
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

// L u at a row; differences first, so that no digits go in constants. Two entries at a time: rows hold an
// even number, which leaves few lengths to mispredict and two sums that do not wait for each other.
inline Pair PairDiffusion::spread(Index row, const Pair* values) const {
  const Pair own = values[row];
  Pair even{}, odd{};
  for (Index e = offsets_[row]; e < offsets_[row + 1]; e += 2) {
    even += weights_[e] * (own - values[columns_[e]]);
    odd += weights_[e + 1] * (own - values[columns_[e + 1]]);
  }
  return even + odd;
}

PairDiffusion::PairSum PairDiffusion::findResidual(const Scaled& terms, std::span<const Pair> right,
                                                   std::span<const Pair> u) {
  return sumBlocks([&](Index begin, Index end) {
    PairSum sum{};
    for (Index i = begin; i < end; ++i) {
      inverse_[i] = 1 / (terms.mass * mass_[i] + terms.stiffness * diagonal_[i]);
      residual_[i] = mass_[i] * (right[i] - terms.mass * u[i]) - terms.stiffness * spread(i, u.data());
      direction_[i] = residual_[i] * inverse_[i];
      add(residual_[i] * direction_[i], sum);
    }
    return sum;
  });
}

PairDiffusion::PairSum PairDiffusion::applyToDirection(const Scaled& terms) {
  return sumBlocks([&](Index begin, Index end) {
    PairSum sum{};
    for (Index i = begin; i < end; ++i) {
      image_[i] = mass_[i] * terms.mass * direction_[i] + terms.stiffness * spread(i, direction_.data());
      add(image_[i] * direction_[i], sum);
    }
    return sum;
  });
}

PairDiffusion::PairSum PairDiffusion::advance(Pair alpha, std::span<Pair> u) {
  return sumBlocks([&](Index begin, Index end) {
    PairSum sum{};
    for (Index i = begin; i < end; ++i) {
      u[i] += alpha * direction_[i];
      residual_[i] -= alpha * image_[i];
      add(residual_[i] * residual_[i] * inverse_[i], sum);
    }
    return sum;
  });
}

void PairDiffusion::turnDirection(Pair beta) {
  parallelFor(mass_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      direction_[i] = residual_[i] * inverse_[i] + beta * direction_[i];
    }
  });
}

int PairDiffusion::solve(const PairTerms& terms, std::span<const Pair> right, std::span<Pair> u) {
  Scaled scaled{};
  for (std::size_t lane = 0; lane < 2; ++lane) {
    scaled.mass[lane] = static_cast<float>(terms.mass[lane]);
    scaled.stiffness[lane] = static_cast<float>(terms.stiffness[lane] / squaredSpacing_);
  }
  PairSum energy = findResidual(scaled, right, u);
  if (!std::isfinite(energy[0] + energy[1])) throw SolverError("the concentrations grew beyond all bounds");
  const PairSum enough = {energy[0] * kTolerance * kTolerance, energy[1] * kTolerance * kTolerance};
  int iterations = 0;
  while ((energy[0] > enough[0] || energy[1] > enough[1]) && iterations < kMostIterations) {
    const PairSum curvature = applyToDirection(scaled);
    Pair alpha{}, beta{};
    for (std::size_t lane = 0; lane < 2; ++lane) {
      // A species that is done rests while the other goes on.
      if (energy[lane] <= enough[lane]) continue;
      if (!(curvature[lane] > 0)) {
        throw SolverError(
            "the matrix of this scheme is not positive definite on these points; take scheme voronoi");
      }
      alpha[lane] = static_cast<float>(energy[lane] / curvature[lane]);
    }
    const PairSum next = advance(alpha, u);
    ++iterations;
    for (std::size_t lane = 0; lane < 2; ++lane) {
      if (energy[lane] > 0) beta[lane] = static_cast<float>(next[lane] / energy[lane]);
    }
    energy = next;
    if (energy[0] > enough[0] || energy[1] > enough[1]) turnDirection(beta);
  }
  return iterations;
}

}  // namespace stipple
