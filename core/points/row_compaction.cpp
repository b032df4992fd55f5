#include "core/points/row_compaction.h"

#include <fmt/format.h>

#include "core/error.h"

namespace stipple {

void checkRowsToRemove(std::span<const Index> rows, Index size) {
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r] >= size || (r > 0 && rows[r] <= rows[r - 1])) {
      throw InvalidInput(
          fmt::format("row {} to remove is {}, expected ascending and below {}", r, rows[r], size));
    }
  }
}

}  // namespace stipple
