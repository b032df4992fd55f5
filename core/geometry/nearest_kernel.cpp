#include "core/geometry/nearest_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/geometry/nearest_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stipple::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

std::size_t collectWithinLanes(const CandidateArrays& c, float x, float y, float z, float limit,
                               float* squaredDistances, std::uint32_t* slots) {
  const hn::CappedTag<float, CandidateArrays::kPadding> f;
  const hn::RebindToUnsigned<decltype(f)> u;
  const std::size_t lanes = hn::Lanes(f);
  const auto qx = hn::Set(f, x), qy = hn::Set(f, y), qz = hn::Set(f, z);
  const auto most = hn::Set(f, limit), zero = hn::Zero(f);
  std::size_t found = 0;
  for (std::size_t i = 0; i < c.count; i += lanes) {
    const auto dx = hn::Sub(hn::LoadU(f, c.x + i), qx);
    const auto dy = hn::Sub(hn::LoadU(f, c.y + i), qy);
    const auto dz = hn::Sub(hn::LoadU(f, c.z + i), qz);
    // Multiplied and added in this order without fusing: the same bits on every instruction set.
    const auto d2 = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
    auto near = hn::And(hn::Le(d2, most), hn::Gt(d2, zero));
    if (i + lanes > c.count) near = hn::And(near, hn::FirstN(f, c.count - i));
    if (hn::AllFalse(f, near)) continue;
    // Whole vectors are written: storing only the lanes that count takes many times as long on some processors.
    const auto place = hn::Iota(u, static_cast<std::uint32_t>(i));
    hn::StoreU(hn::Compress(d2, near), f, squaredDistances + found);
    hn::StoreU(hn::Compress(place, hn::RebindMask(u, near)), u, slots + found);
    found += hn::CountTrue(f, near);
  }
  return found;
}

std::size_t countUpToLanes(const float* values, std::size_t count, float threshold) {
  const hn::CappedTag<float, CandidateArrays::kPadding> f;
  const std::size_t lanes = hn::Lanes(f);
  const auto most = hn::Set(f, threshold);
  std::size_t found = 0, i = 0;
  for (; i + lanes <= count; i += lanes) found += hn::CountTrue(f, hn::Le(hn::LoadU(f, values + i), most));
  for (; i < count; ++i) found += values[i] <= threshold;
  return found;
}

}  // namespace stipple::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stipple {

HWY_EXPORT(collectWithinLanes);
HWY_EXPORT(countUpToLanes);

std::size_t collectWithin(const CandidateArrays& candidates, float x, float y, float z, float limit,
                          float* squaredDistances, std::uint32_t* slots) {
  return HWY_DYNAMIC_DISPATCH(collectWithinLanes)(candidates, x, y, z, limit, squaredDistances, slots);
}

std::size_t countUpTo(const float* values, std::size_t count, float threshold) {
  return HWY_DYNAMIC_DISPATCH(countUpToLanes)(values, count, threshold);
}

}  // namespace stipple
#endif
