#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/obj_file.h"

namespace stipple {

/// The color of each vertex: the mean over its corners of what the PNG texture of their material shows; white
/// where no corner has one. The texture is the map_Kd of the .mtl file; without it one beside the file that
/// is named like it. Empty, with a warning where one was promised, if there is no texture that can be read.
std::vector<Rgba8> textureColors(const std::filesystem::path& path, const ObjFile& object,
                                 std::vector<std::string>& warnings);

}  // namespace stipple
