#include "core/io/number_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/io/numbers.h"
#include "core/io/row_assembler.h"

namespace stipple {

namespace {

template <class T>
void store(double value, std::byte* target) {
  const auto stored = static_cast<T>(value);
  std::memcpy(target, &stored, sizeof stored);
}

// The types that text columns are given.
void storeNumber(double value, ScalarType type, std::byte* target) {
  if (type == ScalarType::kFloat64)
    store<double>(value, target);
  else if (type == ScalarType::kUint8)
    store<std::uint8_t>(value, target);
  else
    store<float>(value, target);
}

}  // namespace

bool NumberTable::areBytes(std::size_t first, std::size_t count) const {
  for (std::size_t row = 0; row < rows(); ++row) {
    for (std::size_t column = first; column < first + count; ++column) {
      const double value = at(row, column);
      if (!(value >= 0 && value <= 255 && value == std::floor(value))) return false;
    }
  }
  return true;
}

bool appendNumbers(std::string_view& line, std::vector<double>& values) {
  const char* at = line.data();
  const char* end = at + line.size();
  for (;;) {
    while (at != end && isSeparator(*at)) ++at;
    if (at == end) return true;
    double value = 0;
    const char* stop = parseNumber(at, end, value);
    if (!stop) {
      line.remove_prefix(static_cast<std::size_t>(at - line.data()));
      return false;
    }
    values.push_back(value);
    at = stop;
  }
}

ScalarType realTypeOf(const NumberTable& table, std::size_t column) {
  constexpr double kExact = 1 << 24;  // integers up to here are floats
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double value = table.at(row, column);
    if (!std::isfinite(value) || std::abs(value) <= kExact) continue;
    const bool lossy = value == std::floor(value) && static_cast<double>(static_cast<float>(value)) != value;
    if (lossy || std::abs(value) > std::numeric_limits<float>::max()) return ScalarType::kFloat64;
  }
  return ScalarType::kFloat32;
}

ReadResult assembleTable(const NumberTable& table, std::vector<RowProperty> properties,
                         std::vector<Triangle> triangles) {
  if (table.rows() >= std::numeric_limits<Index>::max()) {
    throw InvalidInput(fmt::format("holds {} points, more than can be kept", table.rows()));
  }
  for (RowProperty& property : properties) {
    if (property.name == "x" || property.name == "y" || property.name == "z")
      property.type = ScalarType::kFloat64;
  }
  RowLayout layout = packedLayout(std::move(properties));
  layout.untyped = true;
  const auto rows = static_cast<Index>(table.rows());
  RowAssembler assembler(std::move(layout), rows);
  const RowLayout& packed = assembler.layout();
  constexpr std::size_t kBlock = 4096;
  std::vector<std::byte> block(std::min<std::size_t>(kBlock, rows) * packed.rowBytes);
  for (std::size_t first = 0; first < rows; first += kBlock) {
    const std::size_t count = std::min<std::size_t>(kBlock, rows - first);
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t column = 0; column < table.columns; ++column) {
        const RowProperty& property = packed.properties[column];
        storeNumber(table.at(first + row, column), property.type,
                    &block[row * packed.rowBytes + property.offset]);
      }
    }
    assembler.decode(std::span(block).first(count * packed.rowBytes), static_cast<Index>(first));
  }
  return assembler.finish(rows, std::move(triangles));
}

}  // namespace stipple
