#include <algorithm>
#include <array>
#include <cmath>
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

namespace hn = hwy::HWY_NAMESPACE;

// One splat a lane.
constexpr std::size_t kMostLanes = 8;
using Floats = hn::CappedTag<float, kMostLanes>;
using Ints = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Ints>;
using M = hn::Mask<Floats>;

HWY_INLINE V all(float value) {
  return hn::Set(Floats(), value);
}
HWY_INLINE V inverse(V v) {
  return hn::Div(all(1), v);
}

struct V3 {
  V x, y, z;
};
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE V3 scaled(const V3& a, V s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE V3 choose(M mask, const V3& yes, const V3& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE V3 rotated(const glm::mat3& m, const V3& a) {
  const auto row = [&](int k) HWY_ATTR { return dot({all(m[0][k]), all(m[1][k]), all(m[2][k])}, a); };
  return {row(0), row(1), row(2)};
}

// unpackNormal() of a splat a lane.
HWY_INLINE V3 unpackNormals(I shape) {
  constexpr float kStep = 2.f / 4095;
  const Floats f;
  const Ints i;
  const auto coordinate = [&](I bits) HWY_ATTR {
    return hn::MulAdd(hn::ConvertTo(f, hn::And(bits, hn::Set(i, 0xfff))), all(kStep), all(-1));
  };
  const V x = coordinate(shape), y = coordinate(hn::ShiftRight<12>(shape));
  const V z = hn::Sub(hn::Sub(all(1), hn::Abs(x)), hn::Abs(y));
  const V fold = hn::Max(hn::Neg(z), hn::Zero(f));
  const V3 n{hn::Sub(x, hn::CopySign(fold, x)), hn::Sub(y, hn::CopySign(fold, y)), z};
  return scaled(n, inverse(hn::Sqrt(dot(n, n))));
}

// The splats at some places, a field a vector.
class Gathered {
 public:
  HWY_INLINE Gathered(std::span<const Splat> splats, const std::int32_t* places) {
    static_assert(sizeof(Splat) % sizeof(float) == 0);
    constexpr int kStride = sizeof(Splat) / sizeof(float);
    base_ = reinterpret_cast<const std::uint8_t*>(splats.data());
    HWY_ALIGN std::int32_t rows[kMostLanes];
    hn::Store(hn::Mul(hn::LoadU(Ints(), places), hn::Set(Ints(), kStride)), Ints(), rows);
    rows_ = hn::Load(Ints(), rows);
  }
  HWY_INLINE V number(std::size_t offset) const {
    return hn::GatherIndex(Floats(), reinterpret_cast<const float*>(base_ + offset), rows_);
  }
  HWY_INLINE I bits(std::size_t offset) const {
    return hn::GatherIndex(Ints(), reinterpret_cast<const std::int32_t*>(base_ + offset), rows_);
  }

 private:
  const std::uint8_t* base_;
  I rows_;
};

struct Range {
  V low, high;
};

// Smallest and largest place along one axis of the picture, over the focal length, of a disc in front of the
// eye: the tangents of the cone through it. n, c along that axis; nz, cz along the line of sight.
// perD: 1 / (r^2 (1 - nz^2) - cz^2), the same for both axes.
HWY_INLINE Range tangentsOf(V n, V c, V nz, V cz, V r2, V perD) {
  const V middle = hn::Neg(hn::Mul(hn::MulAdd(hn::Mul(r2, n), nz, hn::Mul(c, cz)), perD));
  const V low = hn::Sub(hn::Mul(r2, hn::NegMulAdd(n, n, all(1))), hn::Mul(c, c));
  const V half = hn::Sqrt(hn::Max(hn::Zero(Floats()), hn::NegMulAdd(low, perD, hn::Mul(middle, middle))));
  return {hn::Sub(middle, half), hn::Add(middle, half)};
}

struct Boxes {
  I x0, y0, x1, y1;
};

// Pixels of a picture whose centers lie inside; none where `isShown` is false.
HWY_INLINE Boxes pixelsWithin(const Range& x, const Range& y, const View& view, M isShown) {
  const Floats f;
  const Ints i;
  const auto low = [&](V v) HWY_ATTR { return hn::Max(hn::Sub(v, all(0.5f)), hn::Zero(f)); };
  const auto high = [&](V v, int size) HWY_ATTR {
    return hn::Min(hn::Sub(v, all(0.5f)), all(static_cast<float>(size - 1)));
  };
  const V x0 = low(x.low), x1 = high(x.high, view.width), y0 = low(y.low), y1 = high(y.high, view.height);
  const M isIn = hn::And(isShown, hn::And(hn::Ge(x1, x0), hn::Ge(y1, y0)));
  const auto whole = [&](V v, float otherwise)
                         HWY_ATTR { return hn::ConvertTo(i, hn::IfThenElse(isIn, v, all(otherwise))); };
  return {whole(hn::Ceil(x0), 0), whole(hn::Ceil(y0), 0), whole(x1, -1), whole(y1, -1)};
}

// What ProjectedSplat holds, a field a vector.
struct Projected {
  V x, y, a0, b0, a1, b1, u0, u1, u2, perScreen, z, radius, red, green, blue;
  V3 n;
  Boxes boxes;
};

class Projector {
 public:
  Projector(const View& view, const Appearance& appearance)
      : view_(view), appearance_(appearance), center_(view.centerPx()) {
    const Rgba8& color = appearance.selectionColor;
    selection_ = {linear_[color.r], linear_[color.g], linear_[color.b]};
  }

  HWY_INLINE Projected project(const Gathered& splats) const {
    const Floats f;
    Projected out;
    const V3 c = toView(splats);
    const bool perspective = view_.isPerspective();
    const V3 towards = perspective ? scaled(c, hn::Div(all(-1), hn::Sqrt(dot(c, c))))
                                   : V3{hn::Zero(f), hn::Zero(f), all(-1)};
    const V3 stored = rotated(view_.viewFromWorld, unpackNormals(splats.bits(offsetof(Splat, shape))));
    const V along = dot(stored, towards), cosine = hn::Abs(along);
    V3 n = choose(hn::Lt(along, hn::Zero(f)), scaled(stored, all(-1)), stored);
    out.n = appearance_.twoSided ? n : stored;
    setColor(splats.bits(offsetof(Splat, color)), out);
    out.z = c.z;
    out.radius = splats.number(offsetof(Splat, radius));
    const V pixels = perspective ? hn::Div(all(view_.focalPx), c.z) : all(view_.focalPx);
    out.x = hn::MulAdd(pixels, c.x, all(center_.x));
    out.y = hn::MulAdd(pixels, c.y, all(center_.y));
    const V screenRadius = screenRadiusOf(hn::Mul(out.radius, pixels));
    out.perScreen = inverse(hn::Mul(screenRadius, screenRadius));
    const M isBefore = hn::Gt(c.z, all(view_.nearDepth));
    if (appearance_.mode == SplatMode::kPoints) {
      setPoint(isBefore, out);
      return out;
    }
    n = choose(hn::Lt(cosine, all(kernel::kLeastCosine)), turned(n, cosine, towards), n);
    perspective ? setPerspective(c, n, isBefore, out) : setOrthographic(n, isBefore, out);
    return out;
  }

 private:
  HWY_INLINE V3 toView(const Gathered& splats) const {
    return rotated(view_.viewFromWorld, {hn::Sub(splats.number(offsetof(Splat, x)), all(view_.eye.x)),
                                         hn::Sub(splats.number(offsetof(Splat, y)), all(view_.eye.y)),
                                         hn::Sub(splats.number(offsetof(Splat, z)), all(view_.eye.z))});
  }

  // Discs that are drawn large enough cover pixels by themselves.
  HWY_INLINE V screenRadiusOf(V discPx) const {
    return hn::Min(
        hn::Max(hn::Sub(all(screen_.radiusPx + screen_.smallDiscPx), discPx), all(screen_.leastRadiusPx)),
        all(screen_.radiusPx));
  }

  HWY_INLINE void setColor(I color, Projected& out) const {
    const Ints i;
    const auto byte = [&](I bits) HWY_ATTR { return hn::And(bits, hn::Set(i, 0xff)); };
    const auto linear = [&](I bits)
                            HWY_ATTR { return hn::GatherIndex(Floats(), linear_.data(), byte(bits)); };
    const V share =
        hn::Mul(hn::ConvertTo(Floats(), byte(hn::ShiftRight<24>(color))), all(kernel::kSelectionShare / 255));
    const auto mixed = [&](V own, float other)
                           HWY_ATTR { return hn::MulAdd(share, hn::Sub(all(other), own), own); };
    out.red = mixed(linear(color), selection_.x);
    out.green = mixed(linear(hn::ShiftRight<8>(color)), selection_.y);
    out.blue = mixed(linear(hn::ShiftRight<16>(color)), selection_.z);
  }

  // The normal in the plane of n and the line of sight that makes the least cosine with it.
  HWY_INLINE V3 turned(const V3& n, V cosine, const V3& towards) const {
    const float sine = std::sqrt(1 - kernel::kLeastCosine * kernel::kLeastCosine);
    const V3 across{hn::NegMulAdd(cosine, towards.x, n.x), hn::NegMulAdd(cosine, towards.y, n.y),
                    hn::NegMulAdd(cosine, towards.z, n.z)};
    const V scale = hn::Div(all(sine), hn::Sqrt(dot(across, across)));
    const V least = all(kernel::kLeastCosine);
    const V3 sum{hn::MulAdd(across.x, scale, hn::Mul(least, towards.x)),
                 hn::MulAdd(across.y, scale, hn::Mul(least, towards.y)),
                 hn::MulAdd(across.z, scale, hn::Mul(least, towards.z))};
    return scaled(sum, inverse(hn::Sqrt(dot(sum, sum))));
  }

  // The pixel that the center lies in.
  HWY_INLINE void setPoint(M isBefore, Projected& out) const {
    const Floats f;
    out.a0 = out.b0 = out.a1 = out.b1 = out.u1 = out.u2 = hn::Zero(f);
    out.u0 = view_.isPerspective() ? inverse(out.z) : out.z;
    const V half = all(0.5f);
    const auto isIn = [&](V v, int size) HWY_ATTR {
      return hn::And(hn::Ge(v, hn::Zero(f)), hn::Lt(v, all(static_cast<float>(size))));
    };
    const M isShown = hn::And(isBefore, hn::And(isIn(out.x, view_.width), isIn(out.y, view_.height)));
    out.x = hn::Add(hn::Floor(out.x), half);
    out.y = hn::Add(hn::Floor(out.y), half);
    out.boxes = pixelsWithin({out.x, out.x}, {out.y, out.y}, view_, isShown);
  }

  struct Basis {
    V3 t0, t1;
  };
  // Duff et al. 2017.
  HWY_INLINE Basis basisOf(const V3& n) const {
    const V sign = hn::CopySign(all(1), n.z), a = hn::Neg(inverse(hn::Add(sign, n.z)));
    const V b = hn::Mul(hn::Mul(n.x, n.y), a);
    return {{hn::MulAdd(hn::Mul(sign, n.x), hn::Mul(n.x, a), all(1)), hn::Mul(sign, b),
             hn::Neg(hn::Mul(sign, n.x))},
            {b, hn::MulAdd(n.y, hn::Mul(n.y, a), sign), hn::Neg(n.y)}};
  }

  HWY_INLINE void setPerspective(const V3& c, const V3& n, M isBefore, Projected& out) const {
    const auto [t0, t1] = basisOf(n);
    const V perPixel = all(1 / view_.focalPx), inPlane = hn::Div(perPixel, dot(n, c));
    const V perRadius = inverse(out.radius);
    out.u0 = inverse(c.z);
    out.u1 = hn::Mul(n.x, inPlane);
    out.u2 = hn::Mul(n.y, inPlane);
    const V c0 = dot(c, t0), c1 = dot(c, t1);
    const auto slope = [&](V t, V u, V along) HWY_ATTR {
      return hn::Mul(hn::NegMulAdd(u, along, hn::Mul(t, perPixel)), perRadius);
    };
    out.a0 = slope(t0.x, out.u1, c0);
    out.b0 = slope(t0.y, out.u2, c0);
    out.a1 = slope(t1.x, out.u1, c1);
    out.b1 = slope(t1.y, out.u2, c1);
    const V r2 = hn::Mul(out.radius, out.radius), z2 = hn::Mul(c.z, c.z);
    const V reach2 = hn::Mul(r2, hn::NegMulAdd(n.z, n.z, all(1)));
    const M reachesBehindEye = hn::Ge(reach2, hn::Mul(all(0.99f), z2));
    const V perD = inverse(hn::Sub(reach2, z2));
    const auto within = [&](V along, V place, float center, int size) HWY_ATTR {
      const Range tangents = tangentsOf(along, place, n.z, c.z, r2, perD);
      const V focal = all(view_.focalPx), middle = all(center);
      return Range{
          hn::IfThenElse(reachesBehindEye, hn::Zero(Floats()), hn::MulAdd(focal, tangents.low, middle)),
          hn::IfThenElse(reachesBehindEye, all(static_cast<float>(size)),
                         hn::MulAdd(focal, tangents.high, middle))};
    };
    setBoxes(within(n.x, c.x, center_.x, view_.width), within(n.y, c.y, center_.y, view_.height), isBefore,
             out);
  }

  HWY_INLINE void setOrthographic(const V3& n, M isBefore, Projected& out) const {
    const auto [t0, t1] = basisOf(n);
    const V perPixel = all(1 / view_.focalPx), perRadius = inverse(out.radius);
    const V perDepth = hn::Div(perPixel, n.z);
    out.u0 = out.z;
    out.u1 = hn::Neg(hn::Mul(n.x, perDepth));
    out.u2 = hn::Neg(hn::Mul(n.y, perDepth));
    const auto slope = [&](V t, V tz, V u)
                           HWY_ATTR { return hn::Mul(hn::MulAdd(tz, u, hn::Mul(t, perPixel)), perRadius); };
    out.a0 = slope(t0.x, t0.z, out.u1);
    out.b0 = slope(t0.y, t0.z, out.u2);
    out.a1 = slope(t1.x, t1.z, out.u1);
    out.b1 = slope(t1.y, t1.z, out.u2);
    const auto within = [&](V along, V place) HWY_ATTR {
      const V half = hn::Mul(hn::Mul(out.radius, all(view_.focalPx)),
                             hn::Sqrt(hn::Max(hn::Zero(Floats()), hn::NegMulAdd(along, along, all(1)))));
      return Range{hn::Sub(place, half), hn::Add(place, half)};
    };
    setBoxes(within(n.x, out.x), within(n.y, out.y), isBefore, out);
  }

  // The extent of the disc, and of the screen-space kernel about its center.
  HWY_INLINE void setBoxes(const Range& x, const Range& y, M isBefore, Projected& out) const {
    const V reach = all(screen_.radiusPx);
    const auto around = [&](const Range& range, V center) HWY_ATTR {
      return Range{hn::Min(range.low, hn::Sub(center, reach)), hn::Max(range.high, hn::Add(center, reach))};
    };
    out.boxes = pixelsWithin(around(x, out.x), around(y, out.y), view_, isBefore);
  }

  const View& view_;
  const Appearance& appearance_;
  const kernel::ScreenKernel& screen_ = kernel::screenKernelOf(appearance_.isOneOfMany);
  const std::array<float, 256>& linear_ = linearTable();
  glm::vec3 selection_{0};
  glm::vec2 center_;
};

HWY_INLINE void storeBoxes(const Boxes& boxes, std::size_t count, auto&& boxOf) {
  HWY_ALIGN std::int32_t sides[4][kMostLanes];
  hn::Store(boxes.x0, Ints(), sides[0]);
  hn::Store(boxes.y0, Ints(), sides[1]);
  hn::Store(boxes.x1, Ints(), sides[2]);
  hn::Store(boxes.y1, Ints(), sides[3]);
  const auto side = [&](int k, std::size_t lane) { return static_cast<std::int16_t>(sides[k][lane]); };
  for (std::size_t lane = 0; lane < count; ++lane)
    boxOf(lane) = PixelBox{side(0, lane), side(1, lane), side(2, lane), side(3, lane)};
}

HWY_INLINE void store(const Projected& p, std::span<ProjectedSplat> splats) {
  constexpr std::size_t kFields = 18;
  static_assert(offsetof(ProjectedSplat, box) == kFields * sizeof(float));
  const V fields[kFields] = {p.x,         p.y, p.a0,     p.b0,  p.a1,  p.b1,  p.u0,  p.u1,    p.u2,
                             p.perScreen, p.z, p.radius, p.n.x, p.n.y, p.n.z, p.red, p.green, p.blue};
  HWY_ALIGN float values[kFields][kMostLanes];
  for (std::size_t k = 0; k < kFields; ++k) hn::Store(fields[k], Floats(), values[k]);
  for (std::size_t lane = 0; lane < splats.size(); ++lane) {
    float* field = &splats[lane].x;
    for (std::size_t k = 0; k < kFields; ++k) field[k] = values[k][lane];
  }
  storeBoxes(p.boxes, splats.size(), [&](std::size_t lane) -> PixelBox& { return splats[lane].box; });
}

void projectAll(std::span<const Splat> splats, std::span<const std::uint32_t> places, const View& view,
                const Appearance& appearance, std::span<ProjectedSplat> projected) {
  const Projector projector(view, appearance);
  const std::size_t lanes = hn::Lanes(Floats());
  HWY_ALIGN std::int32_t lane[kMostLanes];
  for (std::size_t begin = 0; begin < places.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, places.size() - begin);
    for (std::size_t k = 0; k < lanes; ++k)
      lane[k] = static_cast<std::int32_t>(places[begin + std::min(k, count - 1)]);
    store(projector.project(Gathered(splats, lane)), projected.subspan(begin, count));
  }
}

// A point of the ball of radius r about c is at most r sqrt(z^2 + x^2) / (z (z - r)) from x / z, seen from
// the eye; the root is at most z + x^2 / (2 z).
void reachAll(std::span<const Splat> splats, const View& view, float screenRadiusPx,
              std::span<SplatReach> reach) {
  constexpr float kSlackPx = 0.01f, kMostOfDepth = 0.95f;
  const Floats f;
  const glm::vec2 center = view.centerPx();
  const bool isPerspective = view.isPerspective();
  const std::size_t lanes = hn::Lanes(f);
  HWY_ALIGN std::int32_t lane[kMostLanes];
  HWY_ALIGN float nearest[kMostLanes];
  for (std::size_t begin = 0; begin < splats.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, splats.size() - begin);
    for (std::size_t k = 0; k < lanes; ++k) lane[k] = static_cast<std::int32_t>(std::min(k, count - 1));
    const Gathered held(splats.subspan(begin), lane);
    const V3 c = rotated(view.viewFromWorld, {hn::Sub(held.number(offsetof(Splat, x)), all(view.eye.x)),
                                              hn::Sub(held.number(offsetof(Splat, y)), all(view.eye.y)),
                                              hn::Sub(held.number(offsetof(Splat, z)), all(view.eye.z))});
    const V radius = held.number(offsetof(Splat, radius)), focal = all(view.focalPx);
    const V before = hn::Sub(c.z, radius);
    const V perDepth = isPerspective ? inverse(c.z) : all(1);
    const V width = isPerspective ? hn::Div(hn::Mul(focal, radius), before) : hn::Mul(focal, radius);
    const M isEverywhere =
        isPerspective ? hn::Gt(radius, hn::Mul(all(kMostOfDepth), c.z)) : hn::Lt(all(1), hn::Zero(f));
    const auto range = [&](V place, float middle) HWY_ATTR {
      const V along = hn::Mul(place, perDepth), at = hn::MulAdd(focal, along, all(middle));
      const V slope = isPerspective ? hn::MulAdd(hn::Mul(along, along), all(0.5f), all(1)) : all(1);
      V half = hn::Add(hn::Max(hn::Mul(width, slope), all(screenRadiusPx)), all(kSlackPx));
      half = hn::IfThenElse(isEverywhere, all(std::numeric_limits<float>::infinity()), half);
      return Range{hn::Sub(at, half), hn::Add(at, half)};
    };
    const M isBefore = hn::Gt(c.z, all(view.nearDepth));
    const Boxes boxes = pixelsWithin(range(c.x, center.x), range(c.y, center.y), view, isBefore);
    hn::Store(before, f, nearest);
    for (std::size_t k = 0; k < count; ++k) reach[begin + k].nearest = nearest[k];
    storeBoxes(boxes, count, [&](std::size_t k) -> PixelBox& { return reach[begin + k].box; });
  }
}

}  // namespace stipple::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stipple {

HWY_EXPORT(reachAll);
HWY_EXPORT(projectAll);

void findReach(std::span<const Splat> splats, const View& view, float screenRadiusPx,
               std::span<SplatReach> reach) {
  HWY_DYNAMIC_DISPATCH(reachAll)(splats, view, screenRadiusPx, reach);
}

void projectSplats(std::span<const Splat> splats, std::span<const std::uint32_t> places, const View& view,
                   const Appearance& appearance, std::span<ProjectedSplat> projected) {
  HWY_DYNAMIC_DISPATCH(projectAll)(splats, places, view, appearance, projected);
}

}  // namespace stipple
#endif
