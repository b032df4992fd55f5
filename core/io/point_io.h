#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/points/point_set.h"
#include "core/progress.h"

namespace stipple {

class InputFile;

/// What a file held. `warnings` are whole sentences about what was ignored or guessed.
struct ReadResult {
  PointSet points;
  Index dropped = 0;  ///< rows left out because a coordinate is not finite
  std::vector<std::string> warnings;
};

enum class Encoding { kBinary, kAscii };

struct WriteOptions {
  Encoding encoding = Encoding::kBinary;  ///< for formats that know both
};

/// Reads a file of any known format, recognized by its content; the name only decides where the content
/// leaves a choice. Throws IoError (missing, a directory, unreadable) or InvalidInput (unknown or unreadable
/// kind, corrupt, no points); the message starts with the path.
ReadResult readPoints(const std::filesystem::path& path, Progress& progress);
ReadResult readPoints(const InputFile& file, Progress& progress);

/// Writes the format that the name asks for, beside the target first and renamed when complete, so that a
/// failure keeps the old file. Returns one sentence for each thing that the format cannot hold. Throws
/// IoError or, where the name asks for no format that is written, InvalidInput; the message starts with the
/// path.
std::vector<std::string> writePoints(const std::filesystem::path& path, const PointSet& points,
                                     const WriteOptions& options, Progress& progress);

/// Throws InvalidInput where the name asks for no format that is written.
void requireWritableFormat(const std::filesystem::path& path);

}  // namespace stipple
