#include "core/io/row_blocks.h"

#include <algorithm>

namespace stipple {

void RowBlocks::writeBlocks(std::size_t count, const std::function<void(std::size_t, std::size_t)>& write) {
  for (std::size_t begin = 0; begin < count; begin += kRows) {
    const std::size_t end = std::min(begin + kRows, count);
    write(begin, end);
    written_ += end - begin;
    progress_.throwIfCancelled();
    progress_.report(static_cast<double>(written_) / static_cast<double>(total_), "writing");
  }
}

void RowBlocks::writeLines(std::size_t count, TextBuffer& text,
                           const std::function<void(std::size_t)>& append) {
  writeBlocks(count, [&](std::size_t begin, std::size_t end) {
    text.clear();
    for (std::size_t row = begin; row < end; ++row) append(row);
    file_.write(text.view());
  });
}

void RowBlocks::writePolygons(std::span<const Triangle> triangles, TextBuffer& text) {
  writeLines(triangles.size(), text, [&](std::size_t row) {
    text.append('3');
    for (const Index corner : triangles[row]) text.append(' ').append(corner);
    text.append('\n');
  });
}

}  // namespace stipple
