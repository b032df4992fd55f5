#pragma once

#include <span>
#include <vector>

#include "core/parallel.h"

namespace stipple {

/// Throws InvalidInput unless the rows ascend strictly and lie below `size`.
void checkRowsToRemove(std::span<const Index> rows, Index size);

/// Removes the rows (ascending, unique), keeping the order of the rest.
template <class T>
void removeRowsFrom(std::vector<T>& column, std::span<const Index> rows) {
  if (rows.empty()) return;
  std::size_t kept = rows.front(), next = 0;
  for (std::size_t row = kept; row < column.size(); ++row) {
    if (next < rows.size() && rows[next] == row) {
      ++next;
    } else {
      column[kept++] = column[row];
    }
  }
  column.resize(kept);
}

/// The inverse: afterwards `values` stand at `rows` and the rest around them in its order.
template <class T>
void insertRowsInto(std::vector<T>& column, std::span<const Index> rows, const std::vector<T>& values) {
  std::size_t from = column.size(), next = rows.size();
  column.resize(column.size() + rows.size());
  for (std::size_t row = column.size(); next > 0;) {
    --row;
    column[row] = rows[next - 1] == row ? values[--next] : column[--from];
  }
}

}  // namespace stipple
