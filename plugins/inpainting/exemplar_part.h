#pragma once

#include "plugins/inpainting/patch_search.h"

namespace stipple {

/// One part of the mask, filled with what similar patches around it have, coarse to fine (Wexler et al.
/// 2007). Vectors are compared and copied in tangent frames: they turn with the surface.
class ExemplarPart {
 public:
  ExemplarPart(AttributeType type, const Hole& hole, Surround surround, float spacing,
               const Progress& progress);
  /// Without sources there is nothing to take from: no step may be made.
  bool hasSources() const { return !levels_.front().sources.empty(); }
  std::size_t targetCount() const { return levels_.front().targets.size(); }

  /// One round of search and vote.
  void step(const Progress& progress);
  bool isFinished() const { return rounds_ == roundCount(); }
  /// Of the rounds, how many are done.
  double share() const { return static_cast<double>(rounds_) / roundCount(); }
  /// What the matches so far stand for: values of single known sites.
  void write(Hole& hole, const Progress& progress) const;

 private:
  int roundCount() const;

  Surround surround_;
  bool areVectors_ = false;
  std::vector<ExemplarLevel> levels_;  // finest first
  std::size_t level_ = 0;
  int rounds_ = 0, roundsOfLevel_ = 0;
  Matches matches_;
};

}  // namespace stipple
