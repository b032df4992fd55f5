#pragma once

#include <filesystem>

#include "render/appearance/image.h"

namespace stipple {

/// Writes an 8-bit sRGB image, with an alpha channel where a pixel is not opaque. The file appears only when
/// it is complete. Throws IoError, InvalidInput where the image is empty.
void writePng(const std::filesystem::path& path, const Image& image);

}  // namespace stipple
