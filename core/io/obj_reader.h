#pragma once

#include "core/io/format.h"

namespace stipple {

bool isObj(const FileSample& file);
/// The vertices of an OBJ file with their triangles; normals averaged over the corners that share a vertex;
/// colors of the vertices or, where they have none, of the PNG textures of their materials.
ReadResult readObj(const InputFile& file, Progress& progress);

}  // namespace stipple
