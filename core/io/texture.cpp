#include "core/io/texture.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>

#include "core/io/input_file.h"

namespace stipple {

Texture::Texture(const std::filesystem::path& path) {
  constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 30;
  constexpr png_uint_32 kLargestSide = 16384;  // 1 GB of pixels
  const InputFile file(path);
  if (file.size() > kLargestFile)
    throw InvalidInput(fmt::format("{}: is too large for a texture", path.string()));
  const std::string content = file.head(file.size());
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto fail = [&](std::string_view what) {
    png_image_free(&image);
    throw InvalidInput(fmt::format("{}: {}", path.string(), what));
  };
  if (!png_image_begin_read_from_memory(&image, content.data(), content.size())) {
    fail(fmt::format("is no PNG image that can be read ({})", image.message));
  }
  if (image.width > kLargestSide || image.height > kLargestSide) {
    fail(fmt::format("is {} x {} pixels, at most {} a side are read", image.width, image.height,
                     kLargestSide));
  }
  image.format = PNG_FORMAT_RGBA;
  pixels_.resize(std::size_t{image.width} * image.height);
  if (!png_image_finish_read(&image, nullptr, pixels_.data(), 0, nullptr)) {
    fail(fmt::format("is a corrupt PNG image ({})", image.message));
  }
  width_ = static_cast<int>(image.width);
  height_ = static_cast<int>(image.height);
}

Eigen::Vector3f Texture::sample(float u, float v) const {
  if (!std::isfinite(u) || !std::isfinite(v)) return Eigen::Vector3f::Constant(255);
  // Coordinates beyond the image repeat it; 1 itself is its last pixel.
  const auto wrapped = [](float t) { return t >= 0 && t <= 1 ? t : t - std::floor(t); };
  const float x =
      std::clamp(wrapped(u) * static_cast<float>(width_) - 0.5F, 0.0F, static_cast<float>(width_ - 1));
  const float y = std::clamp((1 - wrapped(v)) * static_cast<float>(height_) - 0.5F, 0.0F,
                             static_cast<float>(height_ - 1));
  const int left = static_cast<int>(x), top = static_cast<int>(y);
  const int right = std::min(left + 1, width_ - 1), bottom = std::min(top + 1, height_ - 1);
  const auto pixel = [&](int column, int row) {
    const Rgba8& color = pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                 static_cast<std::size_t>(column)];
    return Eigen::Vector3f(color.r, color.g, color.b);
  };
  const float fx = x - static_cast<float>(left), fy = y - static_cast<float>(top);
  return (1 - fy) * ((1 - fx) * pixel(left, top) + fx * pixel(right, top)) +
         fy * ((1 - fx) * pixel(left, bottom) + fx * pixel(right, bottom));
}

}  // namespace stipple
