#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "app/tools/pick_at.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// A strip of the plane z = height + slope x, for x in [left, right] and all y.
struct Strip {
  float height = 0, slope = 0;
  float left = -100, right = 100;
};

/// Strips seen from 4 above the origin, x to the right, in a picture of 800 x 600.
struct PickScene {
  std::vector<Strip> strips = {{}};
  View view = frameView({{0, 0, 0}, 4 * std::sin(0.5f * kFieldOfView)},
                        {.pitch = std::numbers::pi_v<float> / 2}, 800, 600);
  mutable int picks = 0;

  /// At the center of the pixel, as renderers do.
  std::optional<Picked> pickAt(const glm::vec2& px) const {
    ++picks;
    const glm::vec3 ray = view.toWorld(view.fromPixels(glm::floor(px) + 0.5f, 1)) - view.eye;
    std::optional<Picked> nearest;
    for (const Strip& strip : strips) {
      const float depth =
          (strip.height + strip.slope * view.eye.x - view.eye.z) / (ray.z - strip.slope * ray.x);
      const glm::vec3 place = view.eye + depth * ray;
      const bool isHit = depth > 0 && place.x >= strip.left && place.x <= strip.right;
      if (isHit && (!nearest || depth < nearest->depth)) nearest = Picked{place, depth};
    }
    return nearest;
  }
  PickAt picker() const {
    return [this](const glm::vec2& px) { return pickAt(px); };
  }
  /// Width of a pixel of the plane z = 0.
  float pixel() const { return 4 / view.focalPx; }
  glm::vec2 pixelOf(const glm::vec3& place) const { return view.toPixels(view.toView(place)); }
  bool isOnAStrip(const glm::vec3& p, float tolerance = 1e-4f) const {
    for (const Strip& s : strips) {
      const bool inside = p.x >= s.left - tolerance && p.x <= s.right + tolerance;
      if (inside && std::abs(p.z - s.height - s.slope * p.x) < tolerance) return true;
    }
    return false;
  }
};

}  // namespace stipple
