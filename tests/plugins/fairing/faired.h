#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "plugins/fairing/fairing.h"

namespace stipple {

using Settings = std::vector<std::pair<std::string, ParameterValue>>;

inline Parameters fairingSettings(const Settings& settings) {
  Parameters parameters(makeFairing()->description().parameters);
  for (const auto& [id, value] : settings) parameters.set(id, value);
  return parameters;
}

/// The points after all steps.
inline PointSet faired(const PointSet& points, const Settings& settings = {}, const Region& region = {}) {
  const auto run = makeFairing()->start(points, region, fairingSettings(settings));
  Progress progress;
  while (!run->step(progress).finished) {
  }
  return run->result().points;
}

}  // namespace stipple
