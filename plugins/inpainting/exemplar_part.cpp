#include "plugins/inpainting/exemplar_part.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stipple {

namespace {

// A level is coarse enough where a target lies at most this many steps from what is known.
constexpr int kCoarsestHops = 8;
constexpr std::size_t kMostLevels = 5;
// With fewer sources a coarse level tells nothing.
constexpr std::size_t kLeastSources = 24;
// Rounds of search and vote at each level.
constexpr int kRounds = 4;

int deepest(const ExemplarLevel& level) {
  int hops = 0;
  for (const Index target : level.targets) hops = std::max(hops, level.hops[target]);
  return hops;
}

Index deepestTarget(const Surround& surround) {
  const auto first = std::ranges::find(surround.kinds, Surround::Kind::kTarget);
  return first == surround.kinds.end() ? 0 : static_cast<Index>(first - surround.kinds.begin());
}

// Colors are compared as they are seen (gamma 2.2), vectors in tangent frames.
Features featuresOf(AttributeType type, const Eigen::MatrixXd& values,
                    std::span<const Eigen::Matrix3f> frames) {
  Features features = values.cast<float>();
  if (type == AttributeType::kColor) features = features.array().max(0).pow(1 / 2.2f).matrix();
  if (type == AttributeType::kVector3) {
    for (std::size_t site = 0; site < frames.size(); ++site)
      features.row(site) = (frames[site].transpose() * features.row(site).transpose()).transpose().eval();
  }
  return features;
}

}  // namespace

ExemplarPart::ExemplarPart(AttributeType type, Surround surround, float spacing, const Progress& progress)
    : surround_(std::move(surround)), areVectors_(type == AttributeType::kVector3) {
  std::vector<Eigen::Matrix3f> frames = carryFrames(surround_.sites, deepestTarget(surround_), &progress);
  Features features = featuresOf(type, surround_.values, frames);
  levels_.push_back(makeFinestLevel(surround_, std::move(frames), std::move(features), spacing, &progress));
  while (levels_.size() < kMostLevels && deepest(levels_.back()) > kCoarsestHops) {
    ExemplarLevel coarser = thinLevel(levels_.back(), &progress);
    if (coarser.sources.size() < kLeastSources || coarser.targets.empty()) break;
    levels_.push_back(std::move(coarser));
  }
  level_ = levels_.size() - 1;
}

int ExemplarPart::roundCount() const {
  return 1 + kRounds * static_cast<int>(levels_.size());
}

void ExemplarPart::step(const Progress& progress) {
  if (rounds_ == 0) {
    matches_.assign(levels_[level_].compared.size(), {});
    fillInLayers(levels_[level_], matches_, &progress);
  } else {
    if (roundsOfLevel_ == kRounds) {
      matches_ = refine(levels_[level_], matches_, levels_[level_ - 1], &progress);
      --level_;
      roundsOfLevel_ = 0;
      copyCenters(levels_[level_], matches_);
    }
    ExemplarLevel& level = levels_[level_];
    std::vector<Index> rows(level.compared.size());
    std::iota(rows.begin(), rows.end(), 0u);
    search(level, rows, level.confidence, static_cast<std::uint64_t>(rounds_), matches_, &progress);
    vote(level, matches_, &progress);
    ++roundsOfLevel_;
  }
  ++rounds_;
}

void ExemplarPart::write(Hole& hole, const Progress& progress) const {
  Matches matches = matches_;
  for (std::size_t level = level_; level > 0; --level)
    matches = refine(levels_[level], matches, levels_[level - 1], &progress);
  const ExemplarLevel& finest = levels_.front();
  for (const Index target : finest.targets) {
    const Index source = matches[finest.comparedRows[target]].source;
    Eigen::RowVectorXd value = surround_.values.row(source);
    if (areVectors_) {
      const Eigen::Matrix3f turn = finest.surface.frames[target] * finest.surface.frames[source].transpose();
      value = (turn.cast<double>() * value.transpose()).transpose().eval();
    }
    hole.values.row(surround_.holeSites[target]) = value;
  }
}

}  // namespace stipple
