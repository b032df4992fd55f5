#pragma once

#include "core/io/format.h"

namespace stipple {

/// OFF, COFF, NOFF or CNOFF with all colors from 0 to 255.
std::vector<std::string> writeOff(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress);

}  // namespace stipple
