#include "app/panels/curve_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/appearance/colormap.h"

namespace stipple {

double CurveScale::heightOf(double value) const {
  if (std::isnan(value) || (isLogarithmic && value <= 0)) return 0;
  const double height =
      isLogarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return std::clamp(height, 0.0, 1.0);
}

CurveScale scaleFor(std::span<const double> values) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (least > most) return {};
  constexpr double kLogarithmicFrom = 50, kRoom = 0.06;
  if (least > 0 && most / least > kLogarithmicFrom) {
    const double room = std::pow(most / least, kRoom);
    return {.low = least / room, .high = most * room, .isLogarithmic = true};
  }
  // Zero belongs to a range that reaches far toward it.
  if (least > 0 && least < 0.5 * most) least = 0;
  if (most < 0 && most > 0.5 * least) most = 0;
  const double range = most - least;
  if (range == 0) {
    const double half = most != 0 ? 0.5 * std::abs(most) : 0.5;
    return {.low = least - half, .high = most + half};
  }
  return {.low = least == 0 ? 0 : least - kRoom * range, .high = most == 0 ? 0 : most + kRoom * range};
}

std::vector<double> ticksOf(const CurveScale& scale, int count) {
  if (!scale.isLogarithmic) return legendTicks(scale.low, scale.high, count);
  const int first = static_cast<int>(std::ceil(std::log10(scale.low)));
  const int last = static_cast<int>(std::floor(std::log10(scale.high)));
  const int step = std::max(1, (last - first + count) / std::max(count, 1));
  std::vector<double> ticks;
  for (int exponent = first; exponent <= last; exponent += step) ticks.push_back(std::pow(10.0, exponent));
  return ticks;
}

}  // namespace stipple
