#pragma once

#include <filesystem>

#include "render/appearance/image.h"

namespace stipple {

/// A PNG as libpng reads it; a failed expectation and an empty image where it cannot.
struct PngPicture {
  int channels = 0;  ///< in the file
  Image image;
};
PngPicture readPng(const std::filesystem::path& path);

}  // namespace stipple
