#pragma once

#include "core/io/format.h"

namespace stipple {

bool isOff(const FileSample& file);
/// Object file format: OFF, COFF, NOFF, CNOFF and ST variants, ASCII. Vertices cut off are an error, faces a
/// warning.
ReadResult readOff(const InputFile& file, Progress& progress);

}  // namespace stipple
