#pragma once

#include <string>

#include "core/geometry/discretization.h"
#include "plugins/api/parameter.h"
#include "plugins/fairing/fairing_tensor.h"

namespace stipple {

/// The parameters of `fairing` as values.
struct FairingOptions {
  int steps = 8;
  double timeStep = 0.25;  ///< in h^2
  FairingTensor tensor = FairingTensor::kFeatures;
  double creaseAngle = 0;  ///< radians
  int k = 0;               ///< neighbors of the classifier; 0: from the noise
  int refresh = 2;         ///< steps that one matrix serves
  bool pinBoundary = true, keepVolume = false, resamples = false;
  std::string weightBy;  ///< attribute that scales the displacement; empty: none
  DiscretizationOptions discretization;
};

std::vector<Parameter> fairingParameters();
FairingOptions fairingOptions(const Parameters& parameters);

}  // namespace stipple
