#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/point_io.h"
#include "core/io/property_plan.h"

namespace stipple {

/// Rows of equal many numbers, as text formats have them.
struct NumberTable {
  std::size_t columns = 0;
  std::vector<double> values;

  std::size_t rows() const { return columns ? values.size() / columns : 0; }
  double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
  /// All values of the columns [first, first + count) are integers from 0 to 255.
  bool areBytes(std::size_t first, std::size_t count) const;
};

/// Appends the numbers of a line. False where a word is no number; `line` then begins with that word.
bool appendNumbers(std::string_view& line, std::vector<double>& values);

/// The narrowest real type that keeps a column of text to about seven digits: float unless large integers or
/// the range ask for double.
ScalarType realTypeOf(const NumberTable& table, std::size_t column);

/// The point set of a table whose columns are these properties (offsets are ignored; x, y and z may be of any
/// real type). Text does not say float or double: coordinates count as double only where they need an origin.
ReadResult assembleTable(const NumberTable& table, std::vector<RowProperty> properties,
                         std::vector<Triangle> triangles);

}  // namespace stipple
