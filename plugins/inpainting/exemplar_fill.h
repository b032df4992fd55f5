#pragma once

#include <optional>

#include "plugins/inpainting/exemplar_part.h"
#include "plugins/inpainting/fills.h"

namespace stipple {

/// Continues textures: what similar patches of the surroundings have (Criminisi et al. 2004). Begins with the
/// tensor fill, which also stays where no whole patch of known values is near.
class ExemplarFill {
 public:
  ExemplarFill(PointSet points, std::string attribute, Region region, Hole& hole, const Progress& progress);
  FillStep step(Hole& hole, const Progress& progress);
  const std::vector<Index>& unreached() const { return tensor_.unreached(); }
  /// Masked points that keep the tensor fill, so far.
  std::size_t pointsWithoutSource() const { return pointsWithoutSource_; }

 private:
  void split(const Hole& hole, const Progress& progress);
  bool openNextPart(const Hole& hole, const Progress& progress);

  PointSet points_;
  std::string attribute_;
  Region region_;
  TensorFill tensor_;
  bool isSplit_ = false;
  float spacing_ = 0;  // of the points in the mask, model units
  std::vector<MaskPart> parts_;
  std::size_t nextPart_ = 0, targetCount_ = 0, finishedTargets_ = 0, pointsWithoutSource_ = 0;
  std::optional<ExemplarPart> part_;
};

}  // namespace stipple
