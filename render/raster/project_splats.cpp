#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/appearance/kernel.h"
#include "render/appearance/light.h"
#include "render/raster/projected_splat.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/raster/project_splats.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stipple::HWY_NAMESPACE {

struct Extent {
  float low, high;
};

// Smallest and largest place along one axis of the picture, over the focal length, of a disc in front of the
// eye: the tangents of the cone through it. n, c along that axis; nz, cz along the line of sight.
// perD: 1 / (r^2 (1 - nz^2) - cz^2), the same for both axes.
inline Extent tangentsOf(float n, float c, float nz, float cz, float r2, float perD) {
  const float middle = (-r2 * n * nz - c * cz) * perD;
  const float half = std::sqrt(std::max(0.f, middle * middle - (r2 * (1 - n * n) - c * c) * perD));
  return {middle - half, middle + half};
}

// Pixels of a picture whose centers lie inside.
inline PixelBox pixelsWithin(const glm::vec2& low, const glm::vec2& high, const glm::vec2& size) {
  const float x0 = std::max(low.x - 0.5f, 0.f), x1 = std::min(high.x - 0.5f, size.x - 1);
  const float y0 = std::max(low.y - 0.5f, 0.f), y1 = std::min(high.y - 0.5f, size.y - 1);
  if (!(x1 >= x0 && y1 >= y0)) return {};
  return {static_cast<std::int16_t>(std::ceil(x0)), static_cast<std::int16_t>(std::ceil(y0)),
          static_cast<std::int16_t>(x1), static_cast<std::int16_t>(y1)};
}

class Projector {
 public:
  Projector(const View& view, const Appearance& appearance) : view_(view), appearance_(appearance) {
    selection_ = glm::vec3(linear_[appearance.selectionColor.r], linear_[appearance.selectionColor.g],
                           linear_[appearance.selectionColor.b]);
    center_ = view.centerPx();
  }

  PixelBox project(const Splat& splat, ProjectedSplat& out) const {
    const glm::vec3 c = view_.toView(splat.center());
    if (!(c.z > view_.nearDepth)) return {};
    const bool perspective = view_.isPerspective();
    const glm::vec3 towards = perspective ? c * (-1 / std::sqrt(glm::dot(c, c))) : glm::vec3(0, 0, -1);
    glm::vec3 n = view_.viewFromWorld * unpackNormal(splat.shape);
    float cosine = glm::dot(n, towards);
    if (cosine < 0) {
      n = -n;
      cosine = -cosine;
    }
    const bool shadesBack =
        !appearance_.twoSided && glm::dot(view_.viewFromWorld * unpackNormal(splat.shape), towards) < 0;
    out.nx = shadesBack ? -n.x : n.x;
    out.ny = shadesBack ? -n.y : n.y;
    out.nz = shadesBack ? -n.z : n.z;
    setColor(splat.color, out);
    out.z = c.z;
    out.radius = splat.radius;
    const float pixels = view_.pixelsPerUnit(c.z);
    out.x = center_.x + pixels * c.x;
    out.y = center_.y + pixels * c.y;
    const float screenRadius = screenRadiusOf(splat.radius * pixels);
    out.perScreen = 1 / (screenRadius * screenRadius);
    if (appearance_.mode == SplatMode::kPoints) return asPoint(out);
    if (cosine < kernel::kLeastCosine) n = glm::normalize(turned(n, cosine, towards));
    return perspective ? asPerspective(c, n, out) : asOrthographic(n, out);
  }

 private:
  // Discs that are drawn large enough cover pixels by themselves.
  static float screenRadiusOf(float discPx) {
    return std::clamp(kernel::kScreenRadiusPx + kernel::kSmallDiscPx - discPx, kernel::kLeastScreenRadiusPx,
                      kernel::kScreenRadiusPx);
  }

  void setColor(const Rgba8& color, ProjectedSplat& out) const {
    out.red = linear_[color.r];
    out.green = linear_[color.g];
    out.blue = linear_[color.b];
    if (color.a == 0) return;
    const float share = kernel::kSelectionShare / 255 * static_cast<float>(color.a);
    out.red += share * (selection_.x - out.red);
    out.green += share * (selection_.y - out.green);
    out.blue += share * (selection_.z - out.blue);
  }

  // The normal in the plane of n and the line of sight that makes the least cosine with it.
  static glm::vec3 turned(const glm::vec3& n, float cosine, const glm::vec3& towards) {
    const float sine = std::sqrt(1 - kernel::kLeastCosine * kernel::kLeastCosine);
    const glm::vec3 across = n - cosine * towards;
    return kernel::kLeastCosine * towards + across * (sine / std::sqrt(glm::dot(across, across)));
  }

  PixelBox asPoint(ProjectedSplat& out) const {
    out.a0 = out.b0 = out.a1 = out.b1 = out.u1 = out.u2 = 0;
    out.u0 = view_.isPerspective() ? 1 / out.z : out.z;
    const float x = std::floor(out.x), y = std::floor(out.y);
    if (!(x >= 0 && y >= 0 && x < static_cast<float>(view_.width) && y < static_cast<float>(view_.height)))
      return {};
    out.x = x + 0.5f;
    out.y = y + 0.5f;
    const auto px = static_cast<std::int16_t>(x), py = static_cast<std::int16_t>(y);
    return {px, py, px, py};
  }

  struct Basis {
    glm::vec3 t0, t1;
  };
  // Duff et al. 2017.
  static Basis basisOf(const glm::vec3& n) {
    const float sign = n.z >= 0 ? 1.f : -1.f, a = -1 / (sign + n.z), b = n.x * n.y * a;
    return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
  }

  PixelBox asPerspective(const glm::vec3& c, const glm::vec3& n, ProjectedSplat& out) const {
    const auto [t0, t1] = basisOf(n);
    const float perPixel = 1 / view_.focalPx, inPlane = perPixel / glm::dot(n, c), perRadius = 1 / out.radius;
    out.u0 = 1 / c.z;
    out.u1 = n.x * inPlane;
    out.u2 = n.y * inPlane;
    const float c0 = glm::dot(c, t0), c1 = glm::dot(c, t1);
    out.a0 = (t0.x * perPixel - out.u1 * c0) * perRadius;
    out.b0 = (t0.y * perPixel - out.u2 * c0) * perRadius;
    out.a1 = (t1.x * perPixel - out.u1 * c1) * perRadius;
    out.b1 = (t1.y * perPixel - out.u2 * c1) * perRadius;
    const float r2 = out.radius * out.radius;
    if (r2 * (1 - n.z * n.z) >= 0.99f * c.z * c.z) {  // reaches behind the eye
      return clip(0, static_cast<float>(view_.width), 0, static_cast<float>(view_.height));
    }
    const float perD = 1 / (r2 * (1 - n.z * n.z) - c.z * c.z);
    const Extent x = tangentsOf(n.x, c.x, n.z, c.z, r2, perD), y = tangentsOf(n.y, c.y, n.z, c.z, r2, perD);
    return around(out, center_.x + view_.focalPx * x.low, center_.x + view_.focalPx * x.high,
                  center_.y + view_.focalPx * y.low, center_.y + view_.focalPx * y.high);
  }

  PixelBox asOrthographic(const glm::vec3& n, ProjectedSplat& out) const {
    const auto [t0, t1] = basisOf(n);
    const float perPixel = 1 / view_.focalPx, perRadius = 1 / out.radius;
    out.u0 = out.z;
    out.u1 = -n.x / n.z * perPixel;
    out.u2 = -n.y / n.z * perPixel;
    out.a0 = (t0.x * perPixel + t0.z * out.u1) * perRadius;
    out.b0 = (t0.y * perPixel + t0.z * out.u2) * perRadius;
    out.a1 = (t1.x * perPixel + t1.z * out.u1) * perRadius;
    out.b1 = (t1.y * perPixel + t1.z * out.u2) * perRadius;
    const float ex = out.radius * view_.focalPx * std::sqrt(1 - n.x * n.x);
    const float ey = out.radius * view_.focalPx * std::sqrt(1 - n.y * n.y);
    return around(out, out.x - ex, out.x + ex, out.y - ey, out.y + ey);
  }

  // The extent of the disc, and of the screen-space kernel about its center.
  PixelBox around(const ProjectedSplat& s, float left, float right, float top, float bottom) const {
    constexpr float kR = kernel::kScreenRadiusPx;
    return clip(std::min(left, s.x - kR), std::max(right, s.x + kR), std::min(top, s.y - kR),
                std::max(bottom, s.y + kR));
  }

  PixelBox clip(float left, float right, float top, float bottom) const {
    return pixelsWithin({left, top}, {right, bottom}, {view_.width, view_.height});
  }

  const View& view_;
  const Appearance& appearance_;
  const std::array<float, 256>& linear_ = linearTable();
  glm::vec3 selection_{0};
  glm::vec2 center_{0};
};

// A point of the ball of radius r about c is at most r sqrt(z^2 + x^2) / (z (z - r)) from x / z, seen from
// the eye; the root is at most z + x^2 / (2 z).
void reachAll(std::span<const Splat> splats, const View& view, std::span<SplatReach> reach) {
  constexpr float kSlackPx = 0.01f;
  const glm::vec2 center = view.centerPx();
  const glm::vec2 size(view.width, view.height);
  const bool isPerspective = view.isPerspective();
  for (std::size_t i = 0; i < splats.size(); ++i) {
    const float radius = splats[i].radius;
    const glm::vec3 c = view.toView(splats[i].center());
    reach[i] = {{}, c.z - radius};
    if (!(c.z > view.nearDepth)) continue;
    const float perDepth = isPerspective ? 1 / c.z : 1;
    const glm::vec2 along(c.x * perDepth, c.y * perDepth);
    const float width =
        view.focalPx * (isPerspective ? radius / std::max(c.z - radius, 0.05f * c.z) : radius);
    const glm::vec2 slope = isPerspective ? 1.f + 0.5f * along * along : glm::vec2(1);
    glm::vec2 half = glm::max(width * slope, kernel::kScreenRadiusPx) + kSlackPx;
    if (isPerspective && radius > 0.95f * c.z) half = glm::vec2(std::numeric_limits<float>::infinity());
    const glm::vec2 at = center + view.focalPx * along;
    reach[i].box = pixelsWithin(at - half, at + half, size);
  }
}

void projectAll(std::span<const Splat> splats, std::span<const std::uint32_t> places, const View& view,
                const Appearance& appearance, std::span<ProjectedSplat> projected) {
  const Projector projector(view, appearance);
  for (std::size_t i = 0; i < places.size(); ++i)
    projected[i].box = projector.project(splats[places[i]], projected[i]);
}

}  // namespace stipple::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stipple {

HWY_EXPORT(reachAll);
HWY_EXPORT(projectAll);

void findReach(std::span<const Splat> splats, const View& view, std::span<SplatReach> reach) {
  HWY_DYNAMIC_DISPATCH(reachAll)(splats, view, reach);
}

void projectSplats(std::span<const Splat> splats, std::span<const std::uint32_t> places, const View& view,
                   const Appearance& appearance, std::span<ProjectedSplat> projected) {
  HWY_DYNAMIC_DISPATCH(projectAll)(splats, places, view, appearance, projected);
}

}  // namespace stipple
#endif
