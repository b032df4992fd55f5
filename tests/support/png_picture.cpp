#include "tests/support/png_picture.h"

#include <gtest/gtest.h>
#include <png.h>

namespace stipple {

PngPicture readPng(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, path.c_str())) {
    ADD_FAILURE() << path << ": " << png.message;
    return {};
  }
  EXPECT_EQ(png.flags & PNG_IMAGE_FLAG_COLORSPACE_NOT_sRGB, 0u);
  PngPicture read{static_cast<int>(PNG_IMAGE_SAMPLE_CHANNELS(png.format)),
                  {static_cast<int>(png.width), static_cast<int>(png.height), {}}};
  png.format = PNG_FORMAT_RGBA;
  read.image.pixels.resize(std::size_t{png.width} * png.height);
  EXPECT_TRUE(png_image_finish_read(&png, nullptr, read.image.pixels.data(), 0, nullptr)) << png.message;
  return read;
}

}  // namespace stipple
