#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/points/point_set.h"
#include "tests/support/shapes.h"

namespace stipple {

/// Random points of the unit sphere with normals, colors, a number and a label.
inline PointSet shownSphere(Index count, std::uint64_t seed = 1) {
  const std::vector<Eigen::Vector3f> positions = shapes::randomSphere(count, seed);
  std::vector<Rgba8> colors;
  std::vector<float> heights;
  std::vector<std::int32_t> labels;
  for (const Eigen::Vector3f& p : positions) {
    const auto channel = [](float x) { return static_cast<std::uint8_t>(std::lround(127.5f * (x + 1))); };
    colors.push_back({channel(p.x()), channel(p.y()), channel(p.z()), 255});
    heights.push_back(p.z());
    labels.push_back(p.x() > 0 ? 1 : 2);
  }
  PointSet points(positions);
  points.set("normal", positions);
  points.set("color", colors);
  points.set("height", heights);
  points.set("label", labels);
  return points;
}

}  // namespace stipple
