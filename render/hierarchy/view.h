#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace stipple {

enum class Projection { kPerspective, kOrthographic };
enum class UpAxis { kY, kZ };

/// A camera and the picture it makes. View space: x right, y down, z forward (depth), units of the world.
/// Pixel (x, y) has its center at (x + .5, y + .5), y from the top.
struct View {
  glm::vec3 eye{0, 0, 0};
  glm::mat3 viewFromWorld{1};  ///< rotation
  Projection projection = Projection::kPerspective;
  float focalPx = 1;        ///< pixels: of the focal length (perspective), or of a world unit (orthographic)
  float nearDepth = 1e-6f;  ///< world units; nothing nearer is drawn
  int width = 0, height = 0;
  glm::vec2 jitterPx{0, 0};  ///< shifts the picture by part of a pixel

  bool isPerspective() const { return projection == Projection::kPerspective; }
  glm::vec3 toView(const glm::vec3& world) const { return viewFromWorld * (world - eye); }
  glm::vec3 toWorld(const glm::vec3& inView) const { return glm::transpose(viewFromWorld) * inView + eye; }
  glm::vec2 centerPx() const {
    return glm::vec2(0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height)) + jitterPx;
  }
  /// Pixels that a world unit across the line of sight covers at this depth.
  float pixelsPerUnit(float depth) const { return isPerspective() ? focalPx / depth : focalPx; }
  /// Where a point of view space falls in the picture.
  glm::vec2 toPixels(const glm::vec3& inView) const {
    return centerPx() + pixelsPerUnit(inView.z) * glm::vec2(inView.x, inView.y);
  }
  /// The point of view space at this pixel position and depth.
  glm::vec3 fromPixels(const glm::vec2& px, float depth) const {
    return glm::vec3((px - centerPx()) / pixelsPerUnit(depth), depth);
  }
};

/// Sphere about the center of the bounding box through its farthest point.
struct FramingSphere {
  glm::vec3 center{0, 0, 0};
  float radius = 1;
};

/// Angles in radians. Yaw turns about the up axis, counterclockwise seen from above; at 0 the camera looks
/// along +Y (up z) or -Z (up y). Pitch > 0 looks down. At zoom 1 the sphere just fits the height of the
/// picture.
struct CameraAngles {
  float yaw = 0, pitch = 0, zoom = 1;
  UpAxis up = UpAxis::kZ;
  Projection projection = Projection::kPerspective;
};

/// Vertical field of view, radians (35 degrees).
inline constexpr float kFieldOfView = 0.6108652382f;

View frameView(const FramingSphere& sphere, const CameraAngles& angles, int width, int height);

}  // namespace stipple
