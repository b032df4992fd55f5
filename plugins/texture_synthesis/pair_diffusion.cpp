#include "plugins/texture_synthesis/pair_diffusion.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"

namespace stipple {

namespace {

constexpr std::size_t kSlice = SlicedRows::kSlice;
constexpr std::size_t kBlock = 2048;  // sites; a multiple of a slice
// A step leaves this share of a uniform change, and what is left acts in the next step. With the least number
// of sweeps patterns grow as close to those of exact solves as with conjugate gradients to 3e-2: two sweeps
// miss the neutral mode of stripes. A bound relative to the values themselves would stop slow growth.
constexpr double kTolerance = 5e-2;
constexpr int kLeastSweeps = 3, kMostSweeps = 400;
// Weight of all that is rougher than the change of a step, relative to that change.
constexpr double kRoughShare = 0.01;
constexpr const char* kIndefinite =
    "the matrix of this scheme is not positive definite on these points; take scheme voronoi";

using LaneSum = std::array<double, 2>;

// Sums of squared changes. In float over as many sites as stay exact enough, in a fixed order.
LaneSum squaredChange(std::span<const float> before, std::span<const float> after, std::size_t begin,
                      std::size_t end) {
  constexpr std::size_t kChunk = 64, kLanes = 8;
  LaneSum sum{};
  for (std::size_t chunk = 2 * begin; chunk < 2 * end; chunk += kChunk) {
    float squares[kLanes] = {};
    for (std::size_t i = chunk; i < std::min(chunk + kChunk, 2 * end); i += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const float change = after[i + lane] - before[i + lane];
        squares[lane] += change * change;
      }
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) sum[lane % 2] += static_cast<double>(squares[lane]);
  }
  return sum;
}

LaneSum addAll(std::span<const LaneSum> parts) {
  LaneSum sum{};
  for (const LaneSum& part : parts) {
    sum[0] += part[0];
    sum[1] += part[1];
  }
  return sum;
}

void keepPositive(std::span<float> values) {
  for (float& value : values) value = std::max(value, 0.f);
}

}  // namespace

PairDiffusion::PairDiffusion(const SparseMatrix& stiffness, std::span<const double> mass, double spacing)
    : sites_(static_cast<std::size_t>(stiffness.rows())), squaredSpacing_(spacing * spacing) {
  const std::size_t slices = (sites_ + kSlice - 1) / kSlice;
  for (auto* values : {&mass_, &diagonal_, &magnitude_}) values->assign(kSlice * slices, 0);
  scratch_.assign(2 * kSlice * slices, 0);
  starts_.push_back(0);
  for (std::size_t slice = 0; slice < slices; ++slice) {
    const std::size_t begin = kSlice * slice, end = std::min(begin + kSlice, sites_);
    std::size_t length = 0;
    for (std::size_t row = begin; row < end; ++row) {
      const auto outer = static_cast<Eigen::Index>(row);
      std::size_t entries = 0;
      for (SparseMatrix::InnerIterator entry(stiffness, outer); entry; ++entry) {
        if (entry.col() != outer && entry.value() != 0) ++entries;
      }
      length = std::max(length, entries);
    }
    const std::size_t start = kSlice * starts_.back();
    starts_.push_back(starts_.back() + static_cast<Index>(length));
    columns_.resize(start + kSlice * length, 0);
    weights_.resize(start + kSlice * length, 0);
    for (std::size_t row = begin; row < end; ++row) {
      const auto outer = static_cast<Eigen::Index>(row);
      std::size_t place = start + (row - begin);
      double sum = 0, magnitude = 0;
      for (SparseMatrix::InnerIterator entry(stiffness, outer); entry; ++entry) {
        if (entry.col() == outer || entry.value() == 0) continue;
        columns_[place] = static_cast<Index>(entry.col());
        weights_[place] = static_cast<float>(-entry.value());
        sum -= entry.value();
        magnitude += std::abs(entry.value());
        place += kSlice;
      }
      for (; place < columns_.size(); place += kSlice) columns_[place] = static_cast<Index>(row);
      diagonal_[row] = static_cast<float>(sum);
      magnitude_[row] = static_cast<float>(magnitude);
      mass_[row] = static_cast<float>(mass[row] / squaredSpacing_);
    }
  }
}

SweepArguments PairDiffusion::argumentsOf(const PairTerms& terms) const {
  SweepArguments arguments{};
  arguments.rows = {starts_.data(), columns_.data(), weights_.data(), mass_.data()};
  for (std::size_t lane = 0; lane < 2; ++lane) {
    arguments.mass[lane] = static_cast<float>(terms.mass[lane]);
    arguments.stiffness[lane] = static_cast<float>(terms.stiffness[lane] / squaredSpacing_);
  }
  return arguments;
}

void PairDiffusion::fillDiagonal(Plan& plan) const {
  const SweepArguments arguments = argumentsOf(plan.terms);
  plan.inverse.assign(2 * paddedSites(), 0);
  for (std::size_t i = 0; i < 2 * sites_; ++i) {
    const std::size_t row = i / 2, lane = i % 2;
    plan.inverse[i] =
        1 / (arguments.mass[lane] * mass_[row] + arguments.stiffness[lane] * std::max(diagonal_[row], 0.f));
  }
}

// Gershgorin's bound for D^-1 (mass M + stiffness L).
double PairDiffusion::largestEigenvalue(const Plan& plan, std::size_t lane) const {
  const SweepArguments arguments = argumentsOf(plan.terms);
  const float mass = arguments.mass[lane], stiffness = arguments.stiffness[lane];
  float largest = 0;
  for (std::size_t row = 0; row < sites_; ++row) {
    const float reach =
        std::abs(mass * mass_[row] + stiffness * diagonal_[row]) + stiffness * magnitude_[row];
    largest = std::max(largest, reach * plan.inverse[2 * row + lane]);
  }
  return static_cast<double>(largest);
}

void PairDiffusion::sweepAll(const SweepArguments& arguments) const {
  parallelFor(paddedSites(), kBlock, [&](std::size_t begin, std::size_t end) {
    sweepSlices(arguments, begin / kSlice, end / kSlice);
  });
}

// With negative weights an eigenvalue of D^-1 A may be negative; then I - 2 / largest D^-1 A stretches some
// vector, and its powers turn any vector there.
void PairDiffusion::requirePositive(const Plan& plan, const LaneSum& largest) const {
  const bool isDominated =
      std::equal(magnitude_.begin(), magnitude_.end(), diagonal_.begin(),
                 [](float magnitude, float diagonal) { return magnitude <= 1.001f * diagonal; });
  if (isDominated) return;
  constexpr int kPowers = 50;
  constexpr double kRounding = 1e-4;
  SweepArguments arguments = argumentsOf(plan.terms);
  for (std::size_t lane = 0; lane < 2; ++lane) arguments.gain[lane] = static_cast<float>(2 / largest[lane]);
  const std::vector<float> zero(2 * paddedSites(), 0);
  std::vector<float> now = zero, after = zero;
  std::mt19937 random(1);
  for (std::size_t i = 0; i < 2 * sites_; ++i) now[i] = static_cast<float>(random()) * 0x1p-31f - 1;
  const auto squaredNorm = [&](std::span<const float> v) {
    LaneSum sum{};
    for (std::size_t i = 0; i < 2 * sites_; ++i) {
      sum[i % 2] += static_cast<double>(v[i] * v[i]) / static_cast<double>(plan.inverse[i]);
    }
    return sum;
  };
  arguments.inverse = plan.inverse.data();
  arguments.right = zero.data();
  LaneSum norm = squaredNorm(now);
  for (int power = 0; power < kPowers; ++power) {
    arguments.before = arguments.now = now.data();
    arguments.after = after.data();
    sweepAll(arguments);
    const LaneSum next = squaredNorm(after);
    for (std::size_t lane = 0; lane < 2; ++lane) {
      if (!(next[lane] <= norm[lane] * (1 + kRounding))) throw SolverError(kIndefinite);
    }
    norm = next;
    now.swap(after);
  }
}

// Of a uniform change, over the area: D^-1 A is mass M / D there. Collected into bins of eigenvalues.
std::vector<SpectrumShare> PairDiffusion::spectrumOfChange(const Plan& plan, std::size_t lane) const {
  constexpr std::size_t kBins = 64;
  constexpr double kBinsOfOctave = 4;
  const float mass = argumentsOf(plan.terms).mass[lane];
  std::array<double, kBins> weights{};
  double area = 0;
  for (std::size_t row = 0; row < sites_; ++row) {
    const auto value = static_cast<double>(mass * mass_[row] * plan.inverse[2 * row + lane]);
    const double bin = std::clamp(std::round(-kBinsOfOctave * std::log2(value)), 0.0, kBins - 1.0);
    weights[static_cast<std::size_t>(bin)] += static_cast<double>(mass_[row]);
    area += static_cast<double>(mass_[row]);
  }
  std::vector<SpectrumShare> shares;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    if (weights[bin] > 0) {
      shares.push_back({std::exp2(-static_cast<double>(bin) / kBinsOfOctave), weights[bin] / area});
    }
  }
  return shares;
}

void PairDiffusion::chooseSweeps(Plan& plan, const LaneSum& largest) const {
  std::array<std::vector<SpectrumShare>, 2> change, all;
  for (std::size_t lane = 0; lane < 2; ++lane) {
    change[lane] = all[lane] = spectrumOfChange(plan, lane);
    addRoughShares(all[lane], largest[lane], kRoughShare);
  }
  for (int count = kLeastSweeps; count <= kMostSweeps; count += 1 + count / 8) {
    bool isStable = true, isEnough = true;
    for (std::size_t lane = 0; lane < 2; ++lane) {
      plan.sweeps[lane] = designSweeps(all[lane], count);
      isStable = isStable && isDamping(plan.sweeps[lane], largest[lane]);
      isEnough = isEnough && remainderOf(plan.sweeps[lane], change[lane]) <= kTolerance;
    }
    if (isStable && isEnough) return;
  }
  throw SolverError("diffusion over so many points in a step is too much; take a smaller size or time step");
}

PairDiffusion::Plan PairDiffusion::plan(const PairTerms& terms) const {
  Plan plan;
  plan.terms = terms;
  fillDiagonal(plan);
  const LaneSum largest = {largestEigenvalue(plan, 0), largestEigenvalue(plan, 1)};
  requirePositive(plan, largest);
  chooseSweeps(plan, largest);
  return plan;
}

PairDiffusion::Outcome PairDiffusion::solve(const Plan& plan, const PairFields& fields,
                                            const std::function<void(std::size_t, std::size_t)>& react) {
  const std::size_t count = plan.sweeps[0].size();
  SweepArguments arguments = argumentsOf(plan.terms);
  arguments.inverse = plan.inverse.data();
  arguments.right = fields.right.data();
  arguments.now = arguments.before = fields.before.data();
  std::vector<LaneSum> parts((paddedSites() + kBlock - 1) / kBlock);
  for (std::size_t sweep = 0; sweep < count; ++sweep) {
    for (std::size_t lane = 0; lane < 2; ++lane) {
      arguments.momentum[lane] = static_cast<float>(plan.sweeps[lane][sweep].momentum);
      arguments.gain[lane] = static_cast<float>(plan.sweeps[lane][sweep].gain);
    }
    const bool isFirst = sweep == 0, isLast = sweep + 1 == count;
    std::span<float> after = (count - sweep) % 2 == 1 ? fields.after : std::span<float>(scratch_);
    arguments.after = after.data();
    parallelFor(paddedSites(), kBlock, [&](std::size_t begin, std::size_t end) {
      if (isFirst) react(begin, std::min(end, sites_));
      sweepSlices(arguments, begin / kSlice, end / kSlice);
      if (isLast) keepPositive(after.subspan(2 * begin, 2 * (end - begin)));
      if (isFirst || isLast) parts[begin / kBlock] = squaredChange(fields.before, after, begin, end);
    });
    if (isFirst && addAll(parts) == LaneSum{}) {
      std::copy(fields.before.begin(), fields.before.end(), fields.after.begin());
      return {};
    }
    arguments.before = arguments.now;
    arguments.now = after.data();
  }
  const LaneSum change = addAll(parts);
  if (!std::isfinite(change[0] + change[1])) throw SolverError("the concentrations grew beyond all bounds");
  return {.sweeps = static_cast<int>(count), .squaredChange = change};
}

}  // namespace stipple
