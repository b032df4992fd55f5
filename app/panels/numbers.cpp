#include "app/panels/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stipple {

namespace {

constexpr const char* kMinus = "\u2212";

std::string superscript(int exponent) {
  constexpr std::array<const char*, 10> kDigits = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                   "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "\u207b" : "";
  for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

std::string withoutTrailingZeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string shortNumber(double value, int digits) {
  if (std::isnan(value)) return "not a number";
  const std::string sign = std::signbit(value) && value != 0 ? kMinus : "";
  const double size = std::abs(value);
  if (std::isinf(size)) return sign + "\u221e";
  if (size == 0) return "0";
  // Rounded first: 9.996 has the exponent of 10.
  const std::string rounded = fmt::format("{:.{}e}", size, digits - 1);
  const std::size_t e = rounded.find('e');
  const int exponent = std::stoi(rounded.substr(e + 1));
  constexpr int kLeast = -4, kMost = 6;
  if (exponent < kLeast || exponent >= kMost) {
    const std::string mantissa = withoutTrailingZeros(rounded.substr(0, e));
    const std::string factor = mantissa == "1" ? "" : mantissa + " \u00d7 ";
    return fmt::format("{}{}10{}", sign, factor, superscript(exponent));
  }
  return sign + withoutTrailingZeros(fmt::format("{:.{}f}", size, std::max(digits - 1 - exponent, 0)));
}

std::string groupedCount(std::int64_t count) {
  std::string text = std::to_string(count);
  const std::ptrdiff_t first = count < 0 ? 1 : 0;
  for (std::ptrdiff_t i = std::ssize(text) - 3; i > first; i -= 3) text.insert(std::size_t(i), 1, ',');
  return text;
}

std::string roundedCount(std::int64_t count) {
  const auto shortened = [](double value, const char* unit) {
    return fmt::format("{:.{}f} {}", value, value < 99.95 ? 1 : 0, unit);
  };
  if (count >= 999'500) return shortened(double(count) / 1e6, "M");
  if (count >= 10'000) return shortened(double(count) / 1e3, "k");
  return groupedCount(count);
}

std::string spokenDuration(double seconds) {
  if (seconds < 1) return "less than a second";
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  const auto minutes = static_cast<std::int64_t>(std::lround(seconds / 60));
  if (minutes < 60) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

}  // namespace stipple
