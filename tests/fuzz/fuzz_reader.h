#pragma once

#include <cstddef>
#include <span>

#include "core/io/input_file.h"
#include "core/io/point_io.h"

namespace stipple {

/// Reads the bytes as a file of that name with one reader; any Error is a fine end, anything else is a
/// finding.
inline int fuzzReader(ReadResult (*read)(const InputFile&, Progress&), const char* name,
                      const unsigned char* bytes, std::size_t size) {
  const InputFile file(name, std::as_bytes(std::span(bytes, size)));
  Progress progress;
  try {
    read(file, progress);
  } catch (const Error&) {
  }
  return 0;
}

}  // namespace stipple
