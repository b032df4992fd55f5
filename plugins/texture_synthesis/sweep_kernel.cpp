#include "plugins/texture_synthesis/sweep_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/texture_synthesis/sweep_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stipple::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Sums and products without fusing, in one order: the same bits on every instruction set.
#if HWY_TARGET == HWY_SCALAR

void sweepLanes(const SweepArguments& a, std::size_t begin, std::size_t end) {
  constexpr std::size_t kSlice = SlicedRows::kSlice;
  for (std::size_t i = 2 * kSlice * begin; i < 2 * kSlice * end; ++i) {
    const std::size_t row = i / 2, lane = i % 2, slice = row / kSlice;
    const float now = a.now[i];
    float spread = 0;
    for (std::size_t e = a.rows.starts[slice]; e < a.rows.starts[slice + 1]; ++e) {
      const std::size_t entry = kSlice * e + row % kSlice;
      spread += a.rows.weights[entry] * (now - a.now[2 * a.rows.columns[entry] + lane]);
    }
    const float residual = a.rows.mass[row] * (a.right[i] - a.mass[lane] * now) - a.stiffness[lane] * spread;
    const float step = a.inverse[i] * (a.gain[lane] * residual);
    a.after[i] = now + (a.momentum[lane] * (now - a.before[i]) + step);
  }
}

#else

using Floats = hn::CappedTag<float, 2 * SlicedRows::kSlice>;

// {x0, x0, x1, x1, ...}.
HWY_INLINE hn::Vec<Floats> loadTwice(const float* x) {
  const hn::Repartition<std::int64_t, Floats> pairs;
  const hn::Rebind<float, decltype(pairs)> half;
  const auto bits = hn::BitCast(hn::RebindToSigned<decltype(half)>(), hn::LoadU(half, x));
  return hn::DupEven(hn::BitCast(Floats(), hn::PromoteTo(pairs, bits)));
}

HWY_INLINE hn::Vec<Floats> setPairs(const float* pair) {
  return hn::OddEven(hn::Set(Floats(), pair[1]), hn::Set(Floats(), pair[0]));
}

// Pair by pair: the gather instruction takes twice as long where it was measured (Zen 4).
template <class D>
HWY_INLINE hn::Vec<D> gatherPairs(D d, const float* values, const std::uint32_t* columns) {
  if constexpr (hn::MaxLanes(D()) == 2) {
    return hn::LoadU(d, values + 2 * std::size_t{*columns});
  } else {
    const hn::Half<D> half;
    const auto low = gatherPairs(half, values, columns);
    return hn::Combine(d, gatherPairs(half, values, columns + hn::MaxLanes(half) / 2), low);
  }
}

void sweepLanes(const SweepArguments& a, std::size_t begin, std::size_t end) {
  const Floats f;
  constexpr std::size_t kSlice = SlicedRows::kSlice, kRows = hn::MaxLanes(Floats()) / 2;
  const auto massTerm = setPairs(a.mass), stiffness = setPairs(a.stiffness);
  const auto momentum = setPairs(a.momentum), gain = setPairs(a.gain);
  const SlicedRows rows = a.rows;
  for (std::size_t slice = begin; slice < end; ++slice) {
    const std::size_t first = kSlice * rows.starts[slice], last = kSlice * rows.starts[slice + 1];
    for (std::size_t part = 0; part < kSlice; part += kRows) {
      const std::size_t row = kSlice * slice + part;
      const auto now = hn::LoadU(f, a.now + 2 * row);
      // Differences first, so that no digits go in constants.
      auto spread = hn::Zero(f);
      for (std::size_t e = first + part; e < last; e += kSlice) {
        const auto difference = hn::Sub(now, gatherPairs(f, a.now, rows.columns + e));
        spread = hn::Add(spread, hn::Mul(loadTwice(rows.weights + e), difference));
      }
      const auto excess = hn::Sub(hn::LoadU(f, a.right + 2 * row), hn::Mul(massTerm, now));
      const auto residual = hn::Sub(hn::Mul(loadTwice(rows.mass + row), excess), hn::Mul(stiffness, spread));
      const auto step = hn::Mul(hn::LoadU(f, a.inverse + 2 * row), hn::Mul(gain, residual));
      const auto drift = hn::Mul(momentum, hn::Sub(now, hn::LoadU(f, a.before + 2 * row)));
      hn::StoreU(hn::Add(now, hn::Add(drift, step)), f, a.after + 2 * row);
    }
  }
}

#endif

}  // namespace stipple::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stipple {

HWY_EXPORT(sweepLanes);

void sweepSlices(const SweepArguments& arguments, std::size_t begin, std::size_t end) {
  HWY_DYNAMIC_DISPATCH(sweepLanes)(arguments, begin, end);
}

}  // namespace stipple
#endif
