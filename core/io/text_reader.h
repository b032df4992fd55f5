#pragma once

#include "core/io/format.h"

namespace stipple {

/// Lines of numbers come within the first lines, at most a count and a line of words before them.
bool isTextCloud(const FileSample& file);
/// Two counts, then lines of 3, 3, 3, 3, 4, 4, 4 and 4 numbers.
bool isPtx(const FileSample& file);
/// Guennebaud's binary point sets, which share the name .pts.
bool isSurfelFile(const FileSample& file);

/// Points line by line: .xyz .pts .pwn .txt .asc .csv. Columns are separated by blanks, tabs, commas or
/// semicolons.
ReadResult readText(const InputFile& file, Progress& progress);
/// Leica scans: a header with a transformation (applied) before each block of points.
ReadResult readPtx(const InputFile& file, Progress& progress);
ReadResult readSurfels(const InputFile& file, Progress& progress);

}  // namespace stipple
