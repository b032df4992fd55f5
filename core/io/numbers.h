#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/points/attribute.h"

namespace stipple {

/// Bytes of one number.
std::size_t sizeOf(ScalarType type);
bool isFloating(ScalarType type);
bool isSigned(ScalarType type);

/// Blank, tab and, inside a line, a stray carriage return.
inline bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
/// What stands between the columns of text clouds.
inline bool isSeparator(char c) {
  return isBlank(c) || c == ',' || c == ';';
}

/// Reads one number that ends at a separator or at `last`, locale-free and correctly rounded. Knows nan, inf
/// and the 1.#QNAN of old Windows programs, a leading +. Returns the first character behind it, null where
/// there is none.
const char* parseNumber(const char* first, const char* last, double& value);
const char* parseNumber(const char* first, const char* last, float& value);

/// Takes the next word off the front of `text`; empty at the end.
std::string_view takeWord(std::string_view& text, bool (*separates)(char) = isBlank);

/// The text without the blanks at both ends.
std::string_view withoutBlanksAround(std::string_view text);

/// A whole word as a number; false where it is none.
bool toNumber(std::string_view word, double& value);
/// A whole word as a count (digits only); false where it is none.
bool toCount(std::string_view word, std::uint64_t& value);

}  // namespace stipple
