#pragma once

#include <string>
#include <vector>

#include "core/io/output_file.h"
#include "core/io/point_io.h"

namespace stipple {

/// Writes all attributes and the triangles, each attribute under the name and type of its file or, where it
/// has none, as scalar_<name>. Returns warnings about names and types that had to change.
std::vector<std::string> writePly(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress);

}  // namespace stipple
