#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/input_file.h"
#include "core/io/output_file.h"
#include "core/io/point_io.h"

namespace stipple {

/// What the choice of a format can look at.
struct FileSample {
  std::string head;       ///< the first bytes of the file; lines end in LF, no byte order mark
  std::string extension;  ///< lower case, with the dot
  std::uint64_t size = 0;
};

/// A kind of file: how it is recognized, read and written.
struct Format {
  std::string_view kind;                                      ///< as people call it: "PLY"
  std::vector<std::string_view> extensions;                   ///< lower case, with the dot
  bool (*matches)(const FileSample&);                         ///< by content
  ReadResult (*read)(const InputFile&, Progress&) = nullptr;  ///< null: known, but not read
  std::vector<std::string> (*write)(OutputFile&, const PointSet&, const WriteOptions&, Progress&) = nullptr;
  std::string_view advice = {};  ///< what to convert it to where it is not read
  bool nameSuffices =
      false;  ///< text whose content may look like nothing: the name decides when no content does
};

/// All known kinds, in the order in which they are tried; those with a magic number come first.
std::span<const Format> formats();

}  // namespace stipple
