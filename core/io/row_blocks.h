#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/io/output_file.h"
#include "core/io/text_buffer.h"
#include "core/points/point_set.h"
#include "core/progress.h"

namespace stipple {

/// Writes the rows of a file in blocks. After each block it reports the share of all `total` rows that are
/// written, and stops when asked.
class RowBlocks {
 public:
  static constexpr std::size_t kRows = 1 << 14;  ///< of a block, at most

  RowBlocks(OutputFile& file, std::size_t total, Progress& progress)
      : file_(file), total_(total), progress_(progress) {}

  /// The next `count` rows: `write(begin, end)` is called for blocks that make up [0, count), in order.
  void writeBlocks(std::size_t count, const std::function<void(std::size_t begin, std::size_t end)>& write);
  /// The next `count` rows as lines of text: `append(row)` puts one line into `text`.
  void writeLines(std::size_t count, TextBuffer& text, const std::function<void(std::size_t row)>& append);
  /// The next rows as OFF and PLY have them in text: the number of corners, then the corners.
  void writePolygons(std::span<const Triangle> triangles, TextBuffer& text);

 private:
  OutputFile& file_;
  std::size_t total_, written_ = 0;
  Progress& progress_;
};

}  // namespace stipple
