#include "app/cli/matrix_market.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "core/io/output_file.h"
#include "core/parallel.h"

namespace stipple {

namespace {

// Rows formatted by one thread at a time, and blocks held in memory before they are written.
constexpr std::size_t kBlockRows = 1 << 13, kBlocksAtOnce = 64;

// Doubles read back exactly from this many significant digits.
constexpr int kDigits = 17;

void appendIndex(std::string& text, Eigen::Index index) {
  char digits[24];
  text.append(digits, std::to_chars(digits, std::end(digits), index + 1).ptr);
  text += ' ';
}

void appendEntry(std::string& text, Eigen::Index row, Eigen::Index column, double value) {
  appendIndex(text, row);
  appendIndex(text, column);
  char digits[32];
  text.append(digits,
              std::to_chars(digits, std::end(digits), value, std::chars_format::general, kDigits).ptr);
  text += '\n';
}

// Writes header and rows; appendRow(text, row) formats the entries of one row, on any thread.
template <class AppendRow>
void writeRows(const std::filesystem::path& path, const std::string& header, std::size_t rows,
               Progress& progress, AppendRow&& appendRow) {
  OutputFile file(path);
  file.write(header);
  std::vector<std::string> texts(kBlocksAtOnce);
  for (std::size_t first = 0; first < rows; first += kBlockRows * kBlocksAtOnce) {
    const std::size_t count = std::min(rows - first, kBlockRows * kBlocksAtOnce);
    for (std::string& text : texts) text.clear();
    const auto format = [&](std::size_t begin, std::size_t end) {
      std::string& text = texts[begin / kBlockRows];
      for (std::size_t row = begin; row < end; ++row) appendRow(text, first + row);
    };
    parallelFor(count, kBlockRows, format, &progress);
    for (const std::string& text : texts) file.write(text);
    progress.report(static_cast<double>(first + count) / static_cast<double>(rows), "writing");
  }
  file.commit();
}

}  // namespace

void writeSymmetric(const std::filesystem::path& path, const PointRows& matrix, Progress& progress) {
  const std::string header = fmt::format("%%MatrixMarket matrix coordinate real symmetric\n{0} {0} {1}\n",
                                         matrix.size(), matrix.countLower());
  writeRows(path, header, matrix.size(), progress, [&](std::string& text, std::size_t row) {
    thread_local std::vector<PointRows::Entry> entries;
    matrix.lowerRow(static_cast<Index>(row), entries);
    for (const auto& [column, value] : entries)
      appendEntry(text, static_cast<Eigen::Index>(row), column, value);
  });
}

void writeDiagonal(const std::filesystem::path& path, std::span<const double> diagonal, Progress& progress) {
  const std::string header =
      fmt::format("%%MatrixMarket matrix coordinate real general\n{0} {0} {0}\n", diagonal.size());
  writeRows(path, header, diagonal.size(), progress, [&](std::string& text, std::size_t row) {
    appendEntry(text, static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(row), diagonal[row]);
  });
}

}  // namespace stipple
