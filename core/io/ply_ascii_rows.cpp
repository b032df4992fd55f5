#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/io/numbers.h"
#include "core/io/ply_rows.h"

namespace stipple {

namespace {

// A row begins on a line of its own and may go on over the lines that follow.
class AsciiPlyRows final : public PlyRows {
 public:
  AsciiPlyRows(const InputFile& file, std::uint64_t offset, std::uint64_t linesBefore)
      : lines_(file, offset, linesBefore) {}

  bool read(const PlyElement& element, std::byte* row) override {
    if (element.properties.empty()) return true;
    if (!nextLine()) return false;
    for (const PlyProperty& property : element.properties) {
      if (property.isList) {
        if (!skipList(property)) return false;
        continue;
      }
      if (!readNumber(property.type, row)) return false;
      row += sizeOf(property.type);
    }
    endRow();
    return true;
  }

  bool readList(const PlyElement& element, std::size_t list, std::vector<std::int64_t>& items) override {
    if (!nextLine()) return false;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      double ignored = 0;
      if (p == list ? !takeList(items) : property.isList ? !skipList(property) : !readReal(ignored))
        return false;
    }
    endRow();
    return true;
  }

  // One digit and one separator for each number; the last line may lack its end.
  std::uint64_t fewestBytes(const PlyElement& element) const override {
    return 2 * element.properties.size();
  }

  std::uint64_t offset() const override { return lines_.offset(); }

  std::vector<std::string> warnings() const override {
    std::vector<std::string> sentences;
    if (extraRows_ > 0) {
      sentences.push_back(
          fmt::format("{} rows have more values than the header declares, the first on line {}; the rest "
                      "of their lines is ignored",
                      extraRows_, firstExtra_));
    }
    if (clamped_ > 0) {
      sentences.push_back(
          fmt::format("{} values are out of the range of their type and were moved to its end, the "
                      "first on line {}",
                      clamped_, firstClamped_));
    }
    return sentences;
  }

 private:
  bool nextLine() {
    while (lines_.next(line_)) {
      at_ = line_.data();
      end_ = at_ + line_.size();
      skipBlanks();
      const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
      if (at_ != end_ && *at_ != '#' && !rest.starts_with("comment") && !rest.starts_with("obj_info"))
        return true;
    }
    at_ = end_ = nullptr;
    return false;
  }

  void skipBlanks() {
    while (at_ != end_ && isBlank(*at_)) ++at_;
  }

  bool toNextWord() {
    skipBlanks();
    return at_ != end_ || nextLine();
  }

  void endRow() {
    skipBlanks();
    if (at_ == end_) return;
    if (extraRows_++ == 0) firstExtra_ = lines_.number();
  }

  [[noreturn]] void failAtWord() const {
    std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    throw InvalidInput(
        fmt::format("line {}: '{}' is not a number", lines_.number(), takeWord(rest).substr(0, 40)));
  }

  template <class Real>
  bool readReal(Real& value) {
    if (!toNextWord()) return false;
    const char* stop = parseNumber(at_, end_, value);
    if (!stop) failAtWord();
    at_ = stop;
    return true;
  }

  template <class Integer>
  bool readInteger(Integer& value) {
    if (!toNextWord()) return false;
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error == std::errc{} && (stop == end_ || isBlank(*stop))) {
      at_ = stop;
      return true;
    }
    double real = 0;  // "1.0", "+1", or a number out of range
    if (!readReal(real)) return false;
    constexpr double kLow = std::numeric_limits<Integer>::lowest(),
                     kHigh = std::numeric_limits<Integer>::max();
    if (!(real >= kLow && real <= kHigh) && clamped_++ == 0) firstClamped_ = lines_.number();
    value = std::isnan(real) ? Integer{0}
            : real <= kLow   ? std::numeric_limits<Integer>::lowest()
            : real >= kHigh  ? std::numeric_limits<Integer>::max()
                             : static_cast<Integer>(real);
    return true;
  }

  template <class T>
  bool readInto(std::byte* target) {
    T value{};
    if constexpr (std::is_floating_point_v<T>) {
      if (!readReal(value)) return false;
    } else if (!readInteger(value)) {
      return false;
    }
    std::memcpy(target, &value, sizeof value);
    return true;
  }

  bool readNumber(ScalarType type, std::byte* target) {
    switch (type) {
      case ScalarType::kInt8:
        return readInto<std::int8_t>(target);
      case ScalarType::kUint8:
        return readInto<std::uint8_t>(target);
      case ScalarType::kInt16:
        return readInto<std::int16_t>(target);
      case ScalarType::kUint16:
        return readInto<std::uint16_t>(target);
      case ScalarType::kInt32:
        return readInto<std::int32_t>(target);
      case ScalarType::kUint32:
        return readInto<std::uint32_t>(target);
      case ScalarType::kFloat32:
        return readInto<float>(target);
      case ScalarType::kFloat64:
        return readInto<double>(target);
    }
    return false;
  }

  bool takeList(std::vector<std::int64_t>& items) {
    std::int64_t count = 0;
    items.clear();
    if (!readInteger(count) || count < 0) return false;
    for (std::int64_t i = 0; i < count; ++i) {
      std::int64_t item = 0;
      if (!readInteger(item)) return false;
      items.push_back(item);
    }
    return true;
  }

  bool skipList(const PlyProperty& property) {
    std::int64_t count = 0;
    if (!readInteger(count)) return false;
    if (count < 0) {
      throw InvalidInput(
          fmt::format("line {}: list '{}' has length {}", lines_.number(), property.name, count));
    }
    double ignored = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      if (!readReal(ignored)) return false;
    }
    return true;
  }

  LineReader lines_;
  std::string_view line_;
  const char* at_ = nullptr;
  const char* end_ = nullptr;
  std::uint64_t extraRows_ = 0, firstExtra_ = 0, clamped_ = 0, firstClamped_ = 0;
};

}  // namespace

std::unique_ptr<PlyRows> openAsciiPlyRows(const InputFile& file, std::uint64_t offset,
                                          std::uint64_t linesBefore) {
  return std::make_unique<AsciiPlyRows>(file, offset, linesBefore);
}

}  // namespace stipple
