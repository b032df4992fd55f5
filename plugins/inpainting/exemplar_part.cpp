#include "plugins/inpainting/exemplar_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stipple {

namespace {

// A level is coarse enough where a target lies at most this many steps from what is known: two radii of a
// patch. Coarser ones do not see textures any more.
constexpr int kCoarsestHops = 6;
constexpr std::size_t kMostLevels = 5;
// With fewer sources a coarse level tells nothing.
constexpr std::size_t kLeastSources = 24;
// Rounds of search and vote at each level. Twice as many took a twentieth off the errors of test textures.
constexpr int kRounds = 6;

int deepest(const ExemplarLevel& level) {
  int hops = 0;
  for (const Index target : level.targets) hops = std::max(hops, level.hops[target]);
  return hops;
}

// The target nearest to the middle of all.
Index middleTarget(const Surround& surround) {
  const std::vector<Eigen::Vector3f>& positions = surround.sites.positions;
  const auto isTarget = [&](Index site) { return surround.kinds[site] == Surround::Kind::kTarget; };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (Index site = 0; site < positions.size(); ++site) {
    if (!isTarget(site)) continue;
    sum += positions[site].cast<double>();
    ++count;
  }
  const Eigen::Vector3f middle = (sum / std::max(count, 1.0)).cast<float>();
  Index best = 0;
  float least = std::numeric_limits<float>::infinity();
  for (Index site = 0; site < positions.size(); ++site) {
    const float distance = (positions[site] - middle).norm();
    if (!isTarget(site) || !(distance < least)) continue;
    least = distance;
    best = site;
  }
  return best;
}

// Colors are compared as they are seen (gamma 2.2), vectors in tangent frames, numbers by their known range.
Features featuresOf(AttributeType type, const Hole& hole, const Eigen::MatrixXd& values,
                    std::span<const Eigen::Matrix3f> frames) {
  if (type == AttributeType::kColor) return values.array().max(0).pow(1 / 2.2).cast<float>();
  const bool areVectors = type == AttributeType::kVector3;
  const Eigen::RowVectorXd offset =
      areVectors ? Eigen::RowVectorXd::Zero(values.cols()).eval() : Eigen::RowVectorXd(hole.least);
  const double range =
      std::max((hole.greatest - offset).cwiseAbs().maxCoeff(), (hole.least - offset).cwiseAbs().maxCoeff());
  if (!(range > 0 && std::isfinite(range))) return Features::Zero(values.rows(), values.cols());
  Features features = ((values.rowwise() - offset) / range).cast<float>();
  for (std::size_t site = 0; areVectors && site < frames.size(); ++site) {
    const Eigen::Vector3f vector = features.row(static_cast<Eigen::Index>(site)).transpose();
    features.row(static_cast<Eigen::Index>(site)) = frames[site].transpose().lazyProduct(vector).transpose();
  }
  return features;
}

}  // namespace

ExemplarPart::ExemplarPart(AttributeType type, const Hole& hole, Surround surround, float spacing,
                           const Progress& progress)
    : surround_(std::move(surround)), areVectors_(type == AttributeType::kVector3) {
  std::vector<Eigen::Matrix3f> frames = carryFrames(surround_.sites, middleTarget(surround_), &progress);
  Features features = featuresOf(type, hole, surround_.values, frames);
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
    Eigen::VectorXd value = surround_.values.row(source).transpose();
    if (areVectors_) {
      const Eigen::Matrix3f turn = finest.surface.frames[target] * finest.surface.frames[source].transpose();
      value = (turn.cast<double>() * value).eval();
    }
    hole.values.row(surround_.holeSites[target]) = value.transpose();
  }
}

}  // namespace stipple
