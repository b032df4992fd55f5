#pragma once

#include "core/io/input_file.h"
#include "core/io/point_io.h"

namespace stipple {

/// Reads ASCII, little-endian and big-endian PLY: the element `vertex`, and `face` or `tristrips` as
/// triangles. Other elements are skipped by their layout. Throws InvalidInput where the header or a vertex is
/// unusable; faces that are cut off after complete vertices are a warning.
ReadResult readPly(const InputFile& file, Progress& progress);

}  // namespace stipple
