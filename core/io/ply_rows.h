#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/io/ply_header.h"

namespace stipple {

/// Walks through the rows of the elements behind a PLY header, whatever the encoding. Rows must be read in
/// the order of the file; after a false the file is at its end.
class PlyRows {
 public:
  virtual ~PlyRows() = default;
  /// Copies the numbers of the next row that are no lists to `row` (packed, in native byte order) and skips
  /// the lists.
  virtual bool read(const PlyElement& element, std::byte* row) = 0;
  /// Reads the next row's list property `list` into `items`, and skips the rest of the row.
  virtual bool readList(const PlyElement& element, std::size_t list, std::vector<std::int64_t>& items) = 0;
  /// Fewest bytes that a row of this element can take in this encoding.
  virtual std::uint64_t fewestBytes(const PlyElement& element) const = 0;
  /// File offset of what comes next.
  virtual std::uint64_t offset() const = 0;
  /// Whole sentences about what was ignored.
  virtual std::vector<std::string> warnings() const { return {}; }
};

std::unique_ptr<PlyRows> openBinaryPlyRows(const InputFile& file, std::uint64_t offset, bool swapBytes);
std::unique_ptr<PlyRows> openAsciiPlyRows(const InputFile& file, std::uint64_t offset,
                                          std::uint64_t linesBefore);

}  // namespace stipple
