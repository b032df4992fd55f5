#include "core/io/text_buffer.h"

#include <charconv>
#include <cstring>

namespace stipple {

namespace {

template <class Number>
void appendNumber(std::string& text, Number value) {
  char digits[32];  // the longest double takes 24
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end);
}

template <class Number>
void appendLoaded(std::string& text, const std::byte* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof value);
  appendNumber(text, value);
}

}  // namespace

TextBuffer& TextBuffer::append(float value) {
  appendNumber(text_, value);
  return *this;
}

TextBuffer& TextBuffer::append(double value) {
  appendNumber(text_, value);
  return *this;
}

TextBuffer& TextBuffer::append(std::int64_t value) {
  appendNumber(text_, value);
  return *this;
}

TextBuffer& TextBuffer::appendStored(const std::byte* number, ScalarType type) {
  switch (type) {
    case ScalarType::kInt8:
      appendLoaded<signed char>(text_, number);
      break;
    case ScalarType::kUint8:
      appendLoaded<unsigned char>(text_, number);
      break;
    case ScalarType::kInt16:
      appendLoaded<std::int16_t>(text_, number);
      break;
    case ScalarType::kUint16:
      appendLoaded<std::uint16_t>(text_, number);
      break;
    case ScalarType::kInt32:
      appendLoaded<std::int32_t>(text_, number);
      break;
    case ScalarType::kUint32:
      appendLoaded<std::uint32_t>(text_, number);
      break;
    case ScalarType::kFloat32:
      appendLoaded<float>(text_, number);
      break;
    case ScalarType::kFloat64:
      appendLoaded<double>(text_, number);
      break;
  }
  return *this;
}

}  // namespace stipple
