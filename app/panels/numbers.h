#pragma once

#include <cstdint>
#include <string>

namespace stipple {

/// About `digits` significant digits without trailing zeros, a true minus sign, powers of ten as such:
/// "0.0125", "−3", "1.5 × 10⁻⁷", "not a number".
std::string shortNumber(double value, int digits = 3);

/// "1,234,567".
std::string groupedCount(std::int64_t count);

/// "12.3 M", "212 k", "950": what a glance takes in.
std::string roundedCount(std::int64_t count);

/// "3 s", "2 min", "1 h 5 min"; "less than a second" below one.
std::string spokenDuration(double seconds);

}  // namespace stipple
