#include "plugins/inpainting/exemplar_fill.h"

#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

// Share of the run that the tensor fill takes.
constexpr double kTensorShare = 0.2;
// Targets that a step brings one round further, where parts are small: many specks take few steps.
constexpr std::size_t kWork = 1000;

// Sites of masked rows that equations reach, ascending.
std::vector<Index> findTargets(const Hole& hole, std::span<const Index> unreached) {
  std::vector<Index> sites;
  for (const Index site : hole.siteOfRow) {
    if (std::ranges::binary_search(hole.unknown, site) && !std::ranges::binary_search(unreached, site))
      sites.push_back(site);
  }
  std::ranges::sort(sites);
  const auto repeated = std::ranges::unique(sites);
  sites.erase(repeated.begin(), repeated.end());
  return sites;
}

}  // namespace

ExemplarFill::ExemplarFill(PointSet points, std::string attribute, Region region, Hole& hole,
                           const Progress& progress)
    : points_(std::move(points)),
      attribute_(std::move(attribute)),
      region_(std::move(region)),
      tensor_(hole, progress) {}

void ExemplarFill::split(const Hole& hole, const Progress& progress) {
  const std::vector<Index> targets = findTargets(hole, unreached());
  double area = 0;
  for (const Index site : targets) area += hole.discretization.mass[site];
  spacing_ =
      static_cast<float>(std::sqrt(area / static_cast<double>(std::max<std::size_t>(targets.size(), 1))));
  parts_ = splitMask(points_, hole, targets, spacing_, &progress);
  targetCount_ = targets.size();
  isSplit_ = true;
}

bool ExemplarFill::openNextPart(const Hole& hole, const Progress& progress) {
  for (; !part_ && nextPart_ < parts_.size(); ++nextPart_) {
    const MaskPart& next = parts_[nextPart_];
    const Attribute& attribute = *points_.find(attribute_);
    ExemplarPart part(attribute.type(), hole, gatherSurround(points_, attribute, region_, hole, next),
                      spacing_, progress);
    if (part.hasSources()) {
      part_ = std::move(part);
      continue;
    }
    finishedTargets_ += next.targets.size();
    pointsWithoutSource_ += static_cast<std::size_t>(std::ranges::count_if(
        hole.siteOfRow, [&](Index site) { return std::ranges::binary_search(next.targets, site); }));
  }
  return part_.has_value();
}

FillStep ExemplarFill::step(Hole& hole, const Progress& progress) {
  if (!isSplit_) {
    FillStep result = tensor_.step(hole, progress);
    if (result.fraction >= 1) split(hole, progress);
    result.fraction *= parts_.empty() && isSplit_ ? 1 : kTensorShare;
    return result;
  }
  const Eigen::MatrixXd before = hole.values;
  for (std::size_t work = 0; work < kWork && openNextPart(hole, progress);) {
    part_->step(progress);
    work += part_->targetCount();
    const bool isFinished = part_->isFinished();
    if (isFinished || work >= kWork) part_->write(hole, progress);
    if (!isFinished) continue;
    finishedTargets_ += part_->targetCount();
    part_.reset();
  }
  double done = static_cast<double>(finishedTargets_);
  if (part_) done += static_cast<double>(part_->targetCount()) * part_->share();
  FillStep result{.change = changeOf(hole, before),
                  .fraction = kTensorShare + (1 - kTensorShare) * done / static_cast<double>(targetCount_)};
  if (!part_ && nextPart_ == parts_.size()) result.fraction = 1;
  return result;
}

}  // namespace stipple
