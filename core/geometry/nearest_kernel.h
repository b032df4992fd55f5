#pragma once

#include <cstddef>
#include <cstdint>

namespace stipple {

/// Candidates of one query as separate coordinate arrays, each readable up to kPadding floats past the end.
struct CandidateArrays {
  static constexpr std::size_t kPadding = 16;
  const float *x, *y, *z;
  std::size_t count;
};

/// Writes squared distance and slot of the candidates with squared distance in (0, limit] to (x, y, z) and returns
/// their number. Outputs need room for count + kPadding. Vectorized for the processor found at run time.
std::size_t collectWithin(const CandidateArrays& candidates, float x, float y, float z, float limit,
                          float* squaredDistances, std::uint32_t* slots);

/// Number of values <= threshold.
std::size_t countUpTo(const float* values, std::size_t count, float threshold);

}  // namespace stipple
