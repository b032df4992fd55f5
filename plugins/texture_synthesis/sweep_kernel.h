#pragma once

#include <cstddef>
#include <cstdint>

namespace stipple {

/// Rows in slices of four (sliced ELLPACK): entry e of the four rows of slice s at 4 e + row, for e from
/// starts[s] to starts[s + 1]; short rows are filled up with weights of 0.
struct SlicedRows {
  static constexpr std::size_t kSlice = 4;
  const std::uint32_t *starts, *columns;
  const float* weights;  ///< -L off the diagonal
  const float* mass;
};

/// Fields of two species, side by side: {a0, b0, a1, b1, ...}; terms: {of a, of b}.
struct SweepArguments {
  SlicedRows rows;
  float mass[2], stiffness[2], momentum[2], gain[2];
  const float *inverse, *right;  ///< 1 / D
  const float *before, *now;
  float* after;  ///< may be `before`
};

/// after = now + momentum (now - before) + gain D^-1 (M right - (mass M + stiffness L) now) in the slices
/// [begin, end). Vectorized for the processor found at run time.
void sweepSlices(const SweepArguments& arguments, std::size_t begin, std::size_t end);

}  // namespace stipple
