#include "core/io/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"
#include "core/io/numbers.h"

namespace stipple {

namespace {

[[noreturn]] void fail(std::uint64_t line, std::string_view what) {
  throw InvalidInput(fmt::format("line {} of the PLY header: {}", line, what));
}

ScalarType typeNamed(std::string_view name, std::uint64_t line) {
  static constexpr std::array<std::pair<std::string_view, ScalarType>, 16> kNames = {{
      {"char", ScalarType::kInt8},
      {"int8", ScalarType::kInt8},
      {"uchar", ScalarType::kUint8},
      {"uint8", ScalarType::kUint8},
      {"short", ScalarType::kInt16},
      {"int16", ScalarType::kInt16},
      {"ushort", ScalarType::kUint16},
      {"uint16", ScalarType::kUint16},
      {"int", ScalarType::kInt32},
      {"int32", ScalarType::kInt32},
      {"uint", ScalarType::kUint32},
      {"uint32", ScalarType::kUint32},
      {"float", ScalarType::kFloat32},
      {"float32", ScalarType::kFloat32},
      {"double", ScalarType::kFloat64},
      {"float64", ScalarType::kFloat64},
  }};
  const auto* found = std::ranges::find(kNames, name, &std::pair<std::string_view, ScalarType>::first);
  if (found == kNames.end()) fail(line, fmt::format("'{}' is no type of number", name));
  return found->second;
}

PlyEncoding encodingNamed(std::string_view name, std::uint64_t line) {
  if (name == "ascii") return PlyEncoding::kAscii;
  if (name == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (name == "binary_big_endian") return PlyEncoding::kBigEndian;
  fail(line, fmt::format("'{}' is no encoding", name));
}

PlyElement parseElement(std::string_view rest, std::uint64_t line) {
  PlyElement element{.name = std::string(takeWord(rest))};
  const std::string_view count = takeWord(rest);
  if (element.name.empty() || !toCount(count, element.count)) {
    fail(line, fmt::format("'{}' is no number of elements", count));
  }
  return element;
}

PlyProperty parseProperty(std::string_view rest, std::uint64_t line) {
  PlyProperty property;
  std::string_view type = takeWord(rest);
  if (type == "list") {
    property.isList = true;
    property.countType = typeNamed(takeWord(rest), line);
    if (isFloating(property.countType))
      fail(line, "the length of a list is a real number, expected an integer");
    type = takeWord(rest);
  }
  property.type = typeNamed(type, line);
  property.name = std::string(takeWord(rest));
  if (property.name.empty()) fail(line, "a property has no name");
  return property;
}

}  // namespace

bool PlyElement::hasLists() const {
  return std::ranges::any_of(properties, &PlyProperty::isList);
}

PlyHeader readPlyHeader(const InputFile& file) {
  PlyHeader header;
  LineReader lines(file);
  std::string_view line;
  bool hasFormat = false;
  lines.next(line);  // "ply", which is how the file was recognized
  while (lines.next(line)) {
    const std::string_view keyword = takeWord(line);
    if (keyword == "end_header") {
      if (!hasFormat) fail(lines.number(), "the line 'format' is missing");
      header.dataOffset = lines.offset();
      header.lines = lines.number();
      return header;
    }
    if (keyword == "format") {
      header.encoding = encodingNamed(takeWord(line), lines.number());
      hasFormat = true;
    } else if (keyword == "element") {
      header.elements.push_back(parseElement(line, lines.number()));
    } else if (keyword == "property") {
      if (header.elements.empty()) fail(lines.number(), "a property stands before the first element");
      header.elements.back().properties.push_back(parseProperty(line, lines.number()));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      fail(lines.number(), fmt::format("'{}' is no keyword", keyword.substr(0, 40)));
    }
  }
  throw InvalidInput("the PLY header ends without 'end_header'");
}

}  // namespace stipple
