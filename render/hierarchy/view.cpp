#include "render/hierarchy/view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stipple {

View frameView(const FramingSphere& sphere, const CameraAngles& angles, int width, int height) {
  const float cy = std::cos(angles.yaw), sy = std::sin(angles.yaw);
  const float cp = std::cos(angles.pitch), sp = std::sin(angles.pitch);
  // In a frame with z up; y up is that frame turned by a quarter about x.
  glm::vec3 forward(-sy * cp, cy * cp, -sp), right(cy, sy, 0);
  if (angles.up == UpAxis::kY) {
    forward = {forward.x, forward.z, -forward.y};
    right = {right.x, right.z, -right.y};
  }
  const glm::vec3 down = glm::cross(forward, right);

  View view;
  view.width = width;
  view.height = height;
  view.projection = angles.projection;
  view.viewFromWorld = glm::transpose(glm::mat3(right, down, forward));
  const float halfHeight = 0.5f * static_cast<float>(height);
  const float distance = sphere.radius / std::sin(0.5f * kFieldOfView) / angles.zoom;
  if (view.isPerspective()) {
    view.focalPx = halfHeight / std::tan(0.5f * kFieldOfView);
    view.eye = sphere.center - distance * forward;
    view.nearDepth = 1e-4f * distance;
  } else {
    // Far enough back that all of the sphere lies before the eye.
    view.focalPx = halfHeight * angles.zoom / sphere.radius;
    view.eye = sphere.center - 2 * sphere.radius * forward;
    view.nearDepth = 0;
  }
  return view;
}

}  // namespace stipple
