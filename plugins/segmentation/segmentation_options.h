#pragma once

#include <string>

#include "core/geometry/discretization.h"
#include "plugins/api/parameter.h"

namespace stipple {

/// blocking: nothing flows along edges across which the surface turns sharply. classifier: A = C, as in the
/// paper.
enum class Diffusivity { kBlocking, kClassifier };
/// farthest from what is blocked or labelled, or where the classifier is largest (the paper).
enum class Seeding { kFarthest, kFlattest };

/// The parameters of the operator `segmentation` as values. Angles in radians.
struct SegmentationOptions {
  DiscretizationOptions discretization;
  std::string seeds;  ///< "auto" or an attribute
  double creaseAngle = 0;
  bool fill = false;
  int k = 0;  ///< 0: from the noise
  Diffusivity diffusivity = Diffusivity::kBlocking;
  int steps = 0;        ///< at most, for each automatic seed or for all given ones together
  double timeStep = 0;  ///< D^2
  double threshold = 0;
  Seeding seeding = Seeding::kFarthest;

  bool hasAutomaticSeeds() const { return seeds == "auto"; }
};

std::vector<Parameter> segmentationParameters();
SegmentationOptions readSegmentationOptions(const Parameters& parameters);

}  // namespace stipple
