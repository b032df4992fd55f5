#include "app/tools/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace stipple {

namespace {

constexpr double kPi = std::numbers::pi;
const double kHalfFieldSine = std::sin(0.5 * kFieldOfView), kHalfFieldTangent = std::tan(0.5 * kFieldOfView);

// Distances to what is zoomed at, in radii of the model: a hundred points of a scan of ten millions across
// the picture; the model as large as a few dozen pixels.
constexpr double kNearest = 1e-3, kFarthest = 50;
constexpr double kZoomStep = 1.2;
// The pivot is given up where it is this much nearer than what is zoomed at: turning about a place at the
// eye moves everything else away.
constexpr double kPassed = 0.25;
// Of the distance, as in frameView.
constexpr double kNearShare = 1e-4;

bool isFinite(const glm::vec2& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}
bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool isUsable(const FramingSphere& sphere) {
  return isFinite(sphere.center) && std::isfinite(sphere.radius);
}

// A single point has a neighborhood too.
FramingSphere withExtent(FramingSphere sphere) {
  if (!(sphere.radius > 0)) sphere.radius = 1;
  return sphere;
}

}  // namespace

OrbitCamera::OrbitCamera(UpAxis up) : up_(up) {
  frame({});
}

CameraAngles OrbitCamera::angles() const {
  return {.yaw = yaw(), .pitch = pitch(), .up = up_, .projection = projection_};
}

glm::dvec3 OrbitCamera::exactEye() const {
  const glm::dmat3 viewFromWorld(frameView({}, angles(), 1, 1).viewFromWorld);
  return pivot_ - glm::transpose(viewFromWorld) * pivotInView_;
}

double OrbitCamera::usableDepth(float depth) const {
  const bool isUsed = projection_ == Projection::kPerspective && depth > 0 && std::isfinite(depth);
  return isUsed ? static_cast<double>(depth) : pivotInView_.z;
}

View OrbitCamera::view(const PictureSize& size) const {
  const auto halfHeight = static_cast<float>(pivotInView_.z * kHalfFieldTangent);
  View view = frameView({.radius = halfHeight}, angles(), size.width, size.height);
  const glm::dvec3 eye = exactEye();
  view.eye = glm::vec3(eye);
  if (view.isPerspective()) {
    const double framed = static_cast<double>(model_.radius) / kHalfFieldSine;
    view.nearDepth = static_cast<float>(kNearShare * std::min(pivotInView_.z, framed));
  } else {
    // Slid along the line of sight until all of the model lies before it.
    const glm::dvec3 forward = glm::transpose(glm::dmat3(view.viewFromWorld)) * glm::dvec3(0, 0, 1);
    const double depth = glm::dot(forward, glm::dvec3(model_.center) - eye);
    view.eye = glm::vec3(eye + (depth - 2 * static_cast<double>(model_.radius)) * forward);
  }
  return view;
}

void OrbitCamera::frame(const FramingSphere& sphere) {
  if (!isUsable(sphere)) return;
  model_ = withExtent(sphere);
  pivot_ = glm::dvec3(model_.center);
  const bool isPerspective = projection_ == Projection::kPerspective;
  pivotInView_ = {0, 0, model_.radius / (isPerspective ? kHalfFieldSine : kHalfFieldTangent)};
}

void OrbitCamera::setModel(const FramingSphere& sphere) {
  if (isUsable(sphere)) model_ = withExtent(sphere);
}

void OrbitCamera::orbit(const glm::vec2& dragPx, const PictureSize& size) {
  if (!isFinite(dragPx) || size.height <= 0) return;
  const double turn = kPi / size.height;
  yaw_ = std::remainder(yaw_ - turn * dragPx.x, 2 * kPi);
  pitch_ = std::clamp(pitch_ + turn * dragPx.y, -kPi / 2, kPi / 2);
}

void OrbitCamera::pan(const glm::vec2& fromPx, const glm::vec2& toPx, float depth, const PictureSize& size) {
  if (!isFinite(fromPx) || !isFinite(toPx) || size.height <= 0) return;
  // What lies at the pivot's depth moves by more or less, as its distance is.
  const double pixelsPerUnit = view(size).pixelsPerUnit(static_cast<float>(usableDepth(depth)));
  pivotInView_.x += static_cast<double>(toPx.x - fromPx.x) / pixelsPerUnit;
  pivotInView_.y += static_cast<double>(toPx.y - fromPx.y) / pixelsPerUnit;
}

void OrbitCamera::zoomToward(const glm::vec2& px, float depth, float steps, const PictureSize& size) {
  if (!isFinite(px) || !std::isfinite(steps) || size.height <= 0) return;
  const double before = usableDepth(depth), radius = model_.radius;
  // A camera that is already beyond a limit does not go farther.
  const double after = std::clamp(before * std::pow(kZoomStep, -static_cast<double>(steps)),
                                  std::min(before, kNearest * radius), std::max(before, kFarthest * radius));
  const View seen = view(size);
  const glm::dvec2 lateral =
      glm::dvec2(px - seen.centerPx()) / static_cast<double>(seen.pixelsPerUnit(static_cast<float>(before)));
  const glm::dvec3 target(lateral, before);
  const glm::dvec3 moved = pivotInView_ - (1 - after / before) * target;
  if (moved.z >= std::min(kPassed * after, pivotInView_.z)) {
    pivotInView_ = moved;
    return;
  }
  pivot_ += glm::transpose(glm::dmat3(seen.viewFromWorld)) * (target - pivotInView_);
  pivotInView_ = (after / before) * target;
}

bool OrbitCamera::setPivot(const glm::vec3& place) {
  if (!isFinite(place)) return false;
  const glm::dmat3 viewFromWorld(frameView({}, angles(), 1, 1).viewFromWorld);
  glm::dvec3 inView = viewFromWorld * (glm::dvec3(place) - exactEye());
  // Parallel lines of sight do not tell how far the eye is; its distance to the pivot is the scale.
  if (projection_ == Projection::kOrthographic) inView.z = pivotInView_.z;
  if (!(inView.z >= 0.5 * kNearest * model_.radius)) return false;
  pivot_ = glm::dvec3(place);
  pivotInView_ = inView;
  return true;
}

void OrbitCamera::turnTo(float yaw, float pitch) {
  if (!std::isfinite(yaw) || !std::isfinite(pitch)) return;
  yaw_ = std::remainder(static_cast<double>(yaw), 2 * kPi);
  pitch_ = std::clamp(static_cast<double>(pitch), -kPi / 2, kPi / 2);
}

void OrbitCamera::show(AxisView side) {
  constexpr auto kQuarter = static_cast<float>(kPi / 2);
  switch (side) {
    case AxisView::kFront:
      return turnTo(0, 0);
    case AxisView::kBack:
      return turnTo(2 * kQuarter, 0);
    case AxisView::kRight:
      return turnTo(kQuarter, 0);
    case AxisView::kLeft:
      return turnTo(-kQuarter, 0);
    case AxisView::kTop:
      return turnTo(0, kQuarter);
    case AxisView::kBottom:
      return turnTo(0, -kQuarter);
  }
}

void OrbitCamera::toggleProjection() {
  const bool isPerspective = projection_ == Projection::kPerspective;
  projection_ = isPerspective ? Projection::kOrthographic : Projection::kPerspective;
}

void OrbitCamera::setUpAxis(UpAxis up) {
  up_ = up;
}

}  // namespace stipple
