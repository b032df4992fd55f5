#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/points/attribute.h"

namespace stipple {

/// Text that grows; numbers are appended with the fewest digits that read back to the same bits.
class TextBuffer {
 public:
  void clear() { text_.clear(); }
  std::string_view view() const { return text_; }
  TextBuffer& append(char c) {
    text_ += c;
    return *this;
  }
  TextBuffer& append(std::string_view text) {
    text_ += text;
    return *this;
  }
  TextBuffer& append(float value);
  TextBuffer& append(double value);
  TextBuffer& append(std::int64_t value);
  TextBuffer& append(std::uint32_t value) { return append(static_cast<std::int64_t>(value)); }
  TextBuffer& append(std::int32_t value) { return append(static_cast<std::int64_t>(value)); }
  /// A number as it lies in memory.
  TextBuffer& appendStored(const std::byte* number, ScalarType type);

 private:
  std::string text_;
};

}  // namespace stipple
