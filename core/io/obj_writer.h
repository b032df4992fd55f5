#pragma once

#include "core/io/format.h"

namespace stipple {

/// `v x y z [r g b]` with colors from 0 to 1, `vn`, `f`.
std::vector<std::string> writeObj(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress);

}  // namespace stipple
