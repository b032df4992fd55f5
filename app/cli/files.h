#pragma once

#include <filesystem>
#include <string>

#include "core/io/point_io.h"

namespace stipple {

/// readPoints, whose every failure ends the command with kFile.
ReadResult readInput(const std::filesystem::path& path, Progress& progress);

/// writePoints, whose every failure ends the command with kFile.
std::vector<std::string> writeOutput(const std::filesystem::path& path, const PointSet& points,
                                     const WriteOptions& options, Progress& progress);

/// Fails with kFile, before any work, where a file of that name could not be written.
void checkWritable(const std::filesystem::path& path);

/// The same, also where the name asks for no format of points that is written.
void checkPointsWritable(const std::filesystem::path& path);

/// A whole text file. Fails with kFile.
std::string readTextFile(const std::filesystem::path& path);

}  // namespace stipple
