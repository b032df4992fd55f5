#pragma once

#include <span>
#include <vector>

namespace stipple {

/// How the values of a curve become heights.
struct CurveScale {
  double low = 0, high = 1;  ///< values at height 0 and 1; low < high; both positive where logarithmic
  bool isLogarithmic = false;

  /// 0..1 within the range, clamped; 0 for what is not a number.
  double heightOf(double value) const;
};

/// Logarithmic where all finite values are positive and span a factor of more than 50, as residuals do;
/// linear otherwise, with zero in sight where it is near. Values that are not finite do not count; without
/// any the scale is 0..1.
CurveScale scaleFor(std::span<const double> values);

/// Powers of ten or round values within the range, ascending, about `count` of them.
std::vector<double> ticksOf(const CurveScale& scale, int count);

}  // namespace stipple
