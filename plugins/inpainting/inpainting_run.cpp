#include "plugins/inpainting/inpainting_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/points/field.h"
#include "plugins/api/fe_parameters.h"

namespace stipple {

InpaintingRun::InpaintingRun(PointSet snapshot, Region region, const Parameters& parameters)
    : snapshot_(std::move(snapshot)),
      result_(snapshot_),
      region_(std::move(region)),
      parameters_(parameters) {
  attribute();
}

const Attribute& InpaintingRun::attribute() const {
  const std::string& name = parameters_.text("attribute");
  if (const Attribute* found = snapshot_.find(name)) return *found;
  throw InvalidInput(fmt::format("there is no attribute \"{}\"", name));
}

void InpaintingRun::prepare(Progress& progress) {
  auto hole = std::make_unique<Hole>(
      prepareHole(snapshot_, attribute(), region_, discretizationOptions(parameters_), progress));
  progress.report(0.8, "equations of the mask");
  std::optional<Fill> fill;
  switch (parameters_.choice<FillMethod>("method")) {
    case FillMethod::kTensor:
      fill.emplace(std::in_place_type<TensorFill>, *hole, progress);
      break;
    case FillMethod::kHarmonic:
      fill.emplace(std::in_place_type<HarmonicFill>, *hole, progress);
      break;
    case FillMethod::kBiharmonic:
      fill.emplace(std::in_place_type<BiharmonicFill>, *hole, progress);
      break;
    case FillMethod::kExemplar:
      fill.emplace(std::in_place_type<ExemplarFill>, snapshot_, attribute().name, region_, *hole, progress);
      break;
  }
  hole_ = std::move(hole);
  fillUnreached(std::visit([](const auto& f) { return f.unreached(); }, *fill), progress);
  fill_ = std::move(fill);
}

void InpaintingRun::fillUnreached(std::span<const Index> unreached, const Progress& progress) {
  if (unreached.empty()) return;
  const Eigen::MatrixXd values =
      nearestKnownValues(snapshot_, attribute(), region_, *hole_, unreached, &progress);
  for (std::size_t u = 0; u < unreached.size(); ++u)
    hole_->values.row(unreached[u]) = values.row(static_cast<Eigen::Index>(u));
  pointsWithoutRim_ = static_cast<std::size_t>(std::ranges::count_if(
      hole_->siteOfRow, [&](Index site) { return std::ranges::binary_search(unreached, site); }));
}

StepState InpaintingRun::step(Progress& progress) {
  if (region_.count(snapshot_.size()) == 0) return {};
  if (!fill_) prepare(progress);
  progress.throwIfCancelled();
  const FillStep done = std::visit([&](auto& fill) { return fill.step(*hole_, progress); }, *fill_);
  ++steps_;
  write();
  progress.report(done.fraction, "filling in");
  return {.finished = done.fraction >= 1, .fraction = done.fraction, .curve = done.change};
}

void InpaintingRun::write() {
  Eigen::MatrixXd values(hole_->maskedRows.size(), hole_->values.cols());
  for (std::size_t r = 0; r < hole_->maskedRows.size(); ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    values.row(row) = hole_->values.row(hole_->siteOfRow[r]);
    if (hole_->areUnitVectors && values.row(row).norm() > 0) values.row(row).normalize();
  }
  writeField(*result_.find(attribute().name), hole_->maskedRows, values);
}

void InpaintingRun::set(const Parameters& parameters) {
  *this = InpaintingRun(std::move(snapshot_), std::move(region_), parameters);
}

Report InpaintingRun::report() const {
  Report report;
  const Index masked = region_.count(snapshot_.size());
  report.values = {{"masked", static_cast<std::int64_t>(masked)}};
  if (masked == 0) report.warnings.push_back("the mask is empty: nothing is filled in");
  if (!hole_) return report;
  report.values.push_back({"surroundings", static_cast<std::int64_t>(hole_->discretization.size())});
  if (pointsWithoutRim_ > 0)
    report.warnings.push_back(fmt::format(
        "{} points are in parts of the mask that touch nothing known: they take the nearest known value",
        pointsWithoutRim_));
  const ExemplarFill* exemplar = fill_ ? std::get_if<ExemplarFill>(&*fill_) : nullptr;
  if (exemplar && exemplar->pointsWithoutSource() > 0)
    report.warnings.push_back(
        fmt::format("{} points have no whole patch of known values near: they are filled by method tensor",
                    exemplar->pointsWithoutSource()));
  return report;
}

}  // namespace stipple
