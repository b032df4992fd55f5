#include "plugins/inpainting/fills.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "plugins/inpainting/color_tensor.h"

namespace stipple {

namespace {

// Slow, not shut: places that creases surround are filled across them.
constexpr double kLeastDiffusivity = 1e-3;
// Steps until a fill is done, as the paper shows it; within them the slowest part of the error in a round
// hole of radius a, which decays with 5.8 / a^2, falls to half a percent.
constexpr int kSteps = 30;
// One harmonic, one with the edges known, two that sharpen; more change little.
constexpr int kTensorSteps = 4;
// Changes below half a step of 8-bit color are not seen.
constexpr double kStandstill = 0.5 / 255;

SparseMatrix creaseStiffness(const Hole& hole, const Progress& progress) {
  std::vector<double> diffusivity = hole.classifier;
  for (double& c : diffusivity) c = std::max(c, kLeastDiffusivity);
  SparseMatrix stiffness =
      assembleStiffness(hole.discretization, diffusivity, EdgeMean::kArithmetic, &progress);
  makeSemidefinite(hole.discretization, stiffness);
  return stiffness;
}

void clampToKnown(Hole& hole) {
  for (const Index site : hole.unknown)
    hole.values.row(site) = hole.values.row(site).cwiseMax(hole.least).cwiseMin(hole.greatest);
}

// Tensors that carry a thousand times more along than across cost conjugate gradients more iterations than
// the seam reckons with; a factorization of this many rows takes a tenth of a second.
SolverOptions solverFor(const Hole& hole) {
  constexpr std::size_t kFactorized = 50000;
  return {.method = hole.unknown.size() < kFactorized ? SolverMethod::kCholesky : SolverMethod::kAuto,
          .tolerance = 1e-6,
          .expectedSolves = static_cast<int>(hole.values.cols())};
}

}  // namespace

double changeOf(const Hole& hole, const Eigen::MatrixXd& before) {
  const Eigen::RowVectorXd range = hole.greatest - hole.least;
  double sum = 0;
  for (const Index site : hole.unknown) {
    for (Eigen::Index c = 0; c < range.size(); ++c) {
      if (range[c] > 0) sum += std::pow((hole.values(site, c) - before(site, c)) / range[c], 2);
    }
  }
  return std::sqrt(sum / static_cast<double>(std::max<Eigen::Index>(hole.unknown.size() * range.size(), 1)));
}

HarmonicFill::HarmonicFill(Hole& hole, const Progress& progress) : solution_(hole.values) {
  const SparseMatrix stiffness = creaseStiffness(hole, progress);
  const EllipticSolver solver(stiffness, hole.unknown, solverFor(hole), &progress);
  solver.solve(solution_, &progress);
  unreached_ = solver.unreached();

  const Discretization& d = hole.discretization;
  double area = 0;
  std::vector<std::uint8_t> isUnknown(d.size(), 0);
  for (const Index site : hole.unknown) {
    area += d.mass[site];
    isUnknown[site] = 1;
  }
  DiffusionOptions options{
      .timeStep = area / std::numbers::pi / kSteps, .held = {}, .solver = solverFor(hole)};
  options.solver.expectedSolves *= kSteps;
  for (Index site = 0; site < d.size(); ++site) {
    if (!isUnknown[site]) options.held.push_back(site);
  }
  stepper_.emplace(stiffness, d.mass, options, &progress);
}

FillStep HarmonicFill::step(Hole& hole, const Progress& progress) {
  const Eigen::MatrixXd before = hole.values;
  // What no equation reaches has been filled otherwise.
  for (const Index site : unreached_) solution_.row(site) = hole.values.row(site);
  Eigen::MatrixXd error = hole.values - solution_;
  stepper_->step(error, &progress);
  hole.values = solution_ + error;
  FillStep result{.change = changeOf(hole, before)};
  ++steps_;
  if (steps_ >= kSteps || result.change < kStandstill) {
    hole.values = solution_;
    result.fraction = 1;
  } else {
    result.fraction = static_cast<double>(steps_) / kSteps;
  }
  return result;
}

TensorFill::TensorFill(Hole& hole, const Progress& progress)
    : shading_(hole, &progress),
      solver_(creaseStiffness(hole, progress), hole.unknown, solverFor(hole), &progress) {
  unreached_ = solver_.unreached();
}

FillStep TensorFill::step(Hole& hole, const Progress& progress) {
  const Eigen::MatrixXd before = hole.values;
  {
    const EvenLight evenLight(shading_, hole.values);
    if (steps_ > 0) {
      const EdgeSource source = steps_ == 1 ? EdgeSource::kKnown : EdgeSource::kCurrent;
      SparseMatrix stiffness =
          assembleStiffness(hole.discretization, edgeTensors(hole, source, &progress), &progress);
      makeSemidefinite(hole.discretization, stiffness);
      solver_.update(stiffness, &progress);
    }
    solver_.solve(hole.values, &progress);
  }
  ++steps_;
  clampToKnown(hole);
  return {.change = changeOf(hole, before), .fraction = static_cast<double>(steps_) / kTensorSteps};
}

BiharmonicFill::BiharmonicFill(Hole& hole, const Progress& progress) {
  const Discretization& d = hole.discretization;
  const SparseMatrix stiffness = assembleStiffness(d, &progress);
  const Eigen::Map<const Eigen::VectorXd> mass(d.mass.data(), static_cast<Eigen::Index>(d.mass.size()));
  const SparseMatrix scaled = mass.cwiseInverse().asDiagonal() * stiffness;
  // The condition of L M^-1 L is the square of that of L: too much for conjugate gradients.
  solver_.emplace(SparseMatrix(stiffness * scaled), hole.unknown,
                  SolverOptions{.method = SolverMethod::kCholesky}, &progress);
}

FillStep BiharmonicFill::step(Hole& hole, const Progress& progress) {
  const Eigen::MatrixXd before = hole.values;
  solver_->solve(hole.values, &progress);
  clampToKnown(hole);
  return {.change = changeOf(hole, before), .fraction = 1};
}

}  // namespace stipple
