#include "core/io/numbers.h"

#include <fast_float/fast_float.h>

#include <charconv>
#include <limits>

namespace stipple {

std::size_t sizeOf(ScalarType type) {
  switch (type) {
    case ScalarType::kInt8:
    case ScalarType::kUint8:
      return 1;
    case ScalarType::kInt16:
    case ScalarType::kUint16:
      return 2;
    case ScalarType::kInt32:
    case ScalarType::kUint32:
    case ScalarType::kFloat32:
      return 4;
    case ScalarType::kFloat64:
      return 8;
  }
  return 0;
}

bool isFloating(ScalarType type) {
  return type == ScalarType::kFloat32 || type == ScalarType::kFloat64;
}

bool isSigned(ScalarType type) {
  return type == ScalarType::kInt8 || type == ScalarType::kInt16 || type == ScalarType::kInt32 ||
         isFloating(type);
}

namespace {

template <class Real>
const char* parse(const char* first, const char* last, Real& value) {
  if (first != last && *first == '+') ++first;
  const auto [end, error] = fast_float::from_chars(first, last, value);
  if (end == first) return nullptr;
  if (end == last || isSeparator(*end)) return end;
  if (*end != '#') return nullptr;
  // 1.#QNAN, -1.#IND: not a number; 1.#INF: infinity.
  const bool infinite = last - end >= 4 && std::string_view(end, 4) == "#INF";
  value = infinite ? std::copysign(std::numeric_limits<Real>::infinity(), value)
                   : std::numeric_limits<Real>::quiet_NaN();
  const char* stop = end;
  while (stop != last && !isSeparator(*stop)) ++stop;
  return stop;
}

}  // namespace

const char* parseNumber(const char* first, const char* last, double& value) {
  return parse(first, last, value);
}
const char* parseNumber(const char* first, const char* last, float& value) {
  return parse(first, last, value);
}

std::string_view takeWord(std::string_view& text, bool (*separates)(char)) {
  std::size_t begin = 0;
  while (begin < text.size() && separates(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !separates(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::string_view withoutBlanksAround(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

bool toNumber(std::string_view word, double& value) {
  return !word.empty() &&
         parseNumber(word.data(), word.data() + word.size(), value) == word.data() + word.size();
}

bool toCount(std::string_view word, std::uint64_t& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return !word.empty() && error == std::errc{} && end == word.data() + word.size();
}

}  // namespace stipple
