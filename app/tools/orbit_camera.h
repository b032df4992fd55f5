#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/hierarchy/view.h"

namespace stipple {

/// Pixels of the picture.
struct PictureSize {
  int width = 0, height = 0;
};

/// The side that is looked at.
enum class AxisView { kFront, kBack, kRight, kLeft, kTop, kBottom };

/// A camera that turns about a pivot. The pivot may be anywhere in the picture or beside it, but is always
/// before the eye. At its depth both projections show the same size. What is not finite changes nothing.
class OrbitCamera {
 public:
  explicit OrbitCamera(UpAxis up = UpAxis::kZ);

  View view(const PictureSize& size) const;
  glm::vec3 eye() const { return glm::vec3(exactEye()); }
  glm::vec3 pivot() const { return glm::vec3(pivot_); }
  float pivotDepth() const { return static_cast<float>(pivotInView_.z); }
  float yaw() const { return static_cast<float>(yaw_); }      ///< in [-pi, pi], see CameraAngles
  float pitch() const { return static_cast<float>(pitch_); }  ///< in [-pi/2, pi/2]
  UpAxis up() const { return up_; }
  Projection projection() const { return projection_; }
  const FramingSphere& model() const { return model_; }

  /// The picture of frameView at zoom 1 from the same angles; the pivot is the center of the sphere.
  void frame(const FramingSphere& sphere);
  /// The model's size alone, from which the limits of zooming follow; the picture stays.
  void setModel(const FramingSphere& sphere);

  /// Turns the model with a drag: by half a turn a picture's height. The pivot stays at its pixel.
  void orbit(const glm::vec2& dragPx, const PictureSize& size);
  /// What is seen at `fromPx` at this depth goes to `toPx`. Depths that are not > 0 or not finite: the
  /// pivot's.
  void pan(const glm::vec2& fromPx, const glm::vec2& toPx, float depth, const PictureSize& size);
  /// Comes nearer (steps > 0) to what is seen at `px` at this depth, which stays there; down to a thousandth
  /// of the model's radius, up to 50 radii away. Where the eye would pass the pivot, what is seen at `px`
  /// becomes the pivot.
  void zoomToward(const glm::vec2& px, float depth, float steps, const PictureSize& size);

  /// The picture stays. False, and nothing changes, where the place is not before the eye.
  bool setPivot(const glm::vec3& place);
  /// The following leave the pivot at its pixel, and what is at its depth as large as it is.
  void turnTo(float yaw, float pitch);
  void show(AxisView side);
  void toggleProjection();
  void setUpAxis(UpAxis up);

 private:
  CameraAngles angles() const;
  glm::dvec3 exactEye() const;
  double usableDepth(float depth) const;

  UpAxis up_;
  Projection projection_ = Projection::kPerspective;
  double yaw_ = 0, pitch_ = 0;
  FramingSphere model_;
  // The eye follows from the pivot and where it is seen, so that turning cannot shift the picture.
  glm::dvec3 pivot_{};
  glm::dvec3 pivotInView_{0, 0, 1};
};

}  // namespace stipple
