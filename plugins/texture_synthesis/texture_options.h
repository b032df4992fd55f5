#pragma once

#include <cstdint>
#include <string>

#include "core/geometry/discretization.h"
#include "plugins/api/parameter.h"
#include "plugins/texture_synthesis/reaction.h"

namespace stipple {

/// The parameters of the operator `texture_synthesis` as values.
struct TextureOptions {
  DiscretizationOptions discretization;
  Pattern pattern = Pattern::kSpots;
  double size = 0;      ///< length; 0: a share of the model
  int steps = 0;        ///< 0: as many as the pattern usually takes
  double timeStep = 0;  ///< 0: that of the pattern
  std::uint64_t seed = 1;
  bool resume = false;
  std::string sizeBy, directionBy;  ///< empty: none
  double seedFraction = 0;
  std::string seeds;  ///< empty: from the classifier
  bool color = false;
  Rgba8 ground, figure;
};

std::vector<Parameter> textureParameters();
/// Throws InvalidInput where a color is none.
TextureOptions readTextureOptions(const Parameters& parameters);

}  // namespace stipple
