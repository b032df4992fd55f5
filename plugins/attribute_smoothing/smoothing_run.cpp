#include "plugins/attribute_smoothing/smoothing_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/points/field.h"
#include "plugins/api/fe_parameters.h"

namespace stipple {

namespace {

// Of 8-bit colors and floats no more digits are kept.
constexpr double kTolerance = 1e-6;
// Where each step has a matrix of its own, from gradients that are estimates.
constexpr double kTolerancePerMatrix = 1e-4;
// Solves with one matrix, and rows, up to which a factorization is worth its time.
constexpr int kSolvesWorthAFactor = 6;
constexpr Eigen::Index kFactorizedRows = 200000;

}  // namespace

SmoothingRun::SmoothingRun(PointSet snapshot, Region region, const Parameters& parameters)
    : snapshot_(std::move(snapshot)),
      result_(snapshot_),
      region_(std::move(region)),
      parameters_(parameters) {
  attribute();
}

const Attribute& SmoothingRun::attribute() const {
  const std::string& name = parameters_.text("attribute");
  if (const Attribute* found = snapshot_.find(name)) return *found;
  throw InvalidInput(fmt::format("there is no attribute \"{}\"", name));
}

std::unique_ptr<DiffusionStepper> SmoothingRun::makeStepper(const Progress& progress) {
  const bool blocks = parameters_.boolean("block_creases");
  const bool isHeat = parameters_.choice<SmoothingMethod>("method") == SmoothingMethod::kHeat;
  const SparseMatrix stiffness = isHeat ? surface_->stiffness(blocks, progress)
                                        : surface_->edgePreservingStiffness(values_, blocks, progress);
  // The matrix of the heat equation serves all steps, one that depends on the values only its own. The seam
  // takes scans for evener than they are, and conjugate gradients for quicker.
  const auto left = std::clamp<std::int64_t>(parameters_.integer("steps") - steps_, 1, 1000);
  SolverOptions solver{.tolerance = isHeat ? kTolerance : kTolerancePerMatrix,
                       .expectedSolves = static_cast<int>((isHeat ? left : 1) * values_.cols())};
  if (solver.expectedSolves >= kSolvesWorthAFactor && values_.rows() <= kFactorizedRows)
    solver.method = SolverMethod::kCholesky;
  const DiffusionOptions options{.timeStep = parameters_.number("time_step") * surface_->squaredSpacing(),
                                 .held = surface_->heldSites(),
                                 .solver = solver};
  return std::make_unique<DiffusionStepper>(stiffness, surface_->discretization().mass, options, &progress);
}

StepState SmoothingRun::step(Progress& progress) {
  const std::int64_t wanted = parameters_.integer("steps");
  if (steps_ >= wanted) return {};
  if (!surface_) {
    PartialProgress preparing(progress, 0, 0.9);
    auto surface = std::make_unique<SmoothingSurface>(snapshot_, attribute(), region_,
                                                      discretizationOptions(parameters_), preparing);
    values_ = surface->givenValues();
    surface_ = std::move(surface);
  }
  const bool isHeat = parameters_.choice<SmoothingMethod>("method") == SmoothingMethod::kHeat;
  std::unique_ptr<DiffusionStepper> stepper = std::move(stepper_);
  if (!stepper) stepper = makeStepper(progress);
  Eigen::MatrixXd next = values_;
  stepper->step(next, &progress);
  const double change = std::sqrt((next - values_).squaredNorm() / std::max<double>(next.size(), 1));
  if (isHeat) stepper_ = std::move(stepper);
  values_ = std::move(next);
  ++steps_;
  write();
  const double fraction = static_cast<double>(steps_) / static_cast<double>(wanted);
  progress.report(fraction, "smoothing");
  return {.finished = steps_ >= wanted, .fraction = std::min(fraction, 1.0), .curve = change};
}

void SmoothingRun::write() {
  const std::vector<Index>& rows = surface_->writtenRows();
  const Sites& sites = surface_->discretization().sites;
  Eigen::MatrixXd values(rows.size(), values_.cols());
  for (std::size_t r = 0; r < rows.size(); ++r)
    values.row(static_cast<Eigen::Index>(r)) = values_.row(sites.siteOfPoint[rows[r]]);
  writeField(*result_.find(attribute().name), rows, values);
}

void SmoothingRun::set(const Parameters& parameters) {
  for (const char* id : {"attribute", "scheme", "metric", "consensus"}) {
    if (parameters.value(id) == parameters_.value(id)) continue;
    *this = SmoothingRun(std::move(snapshot_), std::move(region_), parameters);
    return;
  }
  parameters_ = parameters;
  stepper_.reset();
}

Report SmoothingRun::report() const {
  Report report;
  report.values = {{"diffusion_steps", static_cast<std::int64_t>(steps_)}};
  if (surface_) report.values.push_back({"spacing", std::sqrt(surface_->squaredSpacing())});
  return report;
}

}  // namespace stipple
