#include "render/raster/edge_factors.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/raster/edge_factors.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace stipple::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void scaleRow(const float* depths, std::size_t count, bool logarithmic, float scale, float* result) {
  const hn::CappedTag<float, kEdgePadding> f;
  const std::size_t lanes = hn::Lanes(f);
  for (std::size_t i = 0; i < count; i += lanes) {
    const auto isThere = hn::FirstN(f, count - i);
    const auto depth = count - i >= lanes ? hn::LoadU(f, depths + i) : hn::MaskedLoad(isThere, f, depths + i);
    const auto isEmpty = hn::Gt(depth, hn::Set(f, 3e38f));
    const auto log = hn::Log2(f, hn::IfThenElse(isEmpty, hn::Set(f, 1), depth));
    const auto value = logarithmic ? hn::IfThenElse(isEmpty, depth, log) : hn::Mul(depth, hn::Set(f, scale));
    hn::BlendedStore(value, isThere, f, result + i);
  }
}

void factorsOfRow(const float* depths, std::ptrdiff_t stride, int count, float strength, float* factors) {
  const hn::CappedTag<float, kEdgePadding> f;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const auto zero = hn::Zero(f), most = hn::Set(f, 3e38f);
  const std::ptrdiff_t places[8] = {-1, 1, -2, 2, -stride, stride, -2 * stride, 2 * stride};
  for (int x = 0; x < count; x += lanes) {
    const auto own = hn::Min(hn::LoadU(f, depths + x), most);
    auto response = zero;
    for (const std::ptrdiff_t place : places) {
      response = hn::Add(response, hn::Max(zero, hn::Sub(own, hn::LoadU(f, depths + x + place))));
    }
    const auto exponent = hn::Max(hn::Mul(response, hn::Set(f, -strength / 8)), hn::Set(f, -8));
    hn::StoreU(hn::Max(hn::Exp(f, exponent), hn::Set(f, 0.25f)), f, factors + x);
  }
}

}  // namespace stipple::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stipple {

HWY_EXPORT(scaleRow);
HWY_EXPORT(factorsOfRow);

void scaleDepths(const float* depths, std::size_t count, bool logarithmic, float scale, float* result) {
  HWY_DYNAMIC_DISPATCH(scaleRow)(depths, count, logarithmic, scale, result);
}

void edgeFactors(const float* depths, std::ptrdiff_t stride, int count, float strength, float* factors) {
  HWY_DYNAMIC_DISPATCH(factorsOfRow)(depths, stride, count, strength, factors);
}

}  // namespace stipple
#endif
