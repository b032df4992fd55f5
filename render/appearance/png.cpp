#include "render/appearance/png.h"

#include <fmt/format.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <string_view>

#include "core/error.h"
#include "core/io/output_file.h"

namespace stipple {

namespace {

// A stream that grows in memory. libpng reports errors by longjmp or by a flag; through its simple interface
// and a stream of the C library no exception has to pass through it.
class MemoryStream {
 public:
  MemoryStream() : stream_(open_memstream(&content_, &size_)) {
    if (!stream_) throw std::bad_alloc();
  }
  ~MemoryStream() {
    fclose(stream_);
    free(content_);
  }
  MemoryStream(const MemoryStream&) = delete;
  MemoryStream& operator=(const MemoryStream&) = delete;

  FILE* get() { return stream_; }
  std::string_view content() {
    if (fflush(stream_) != 0) throw std::bad_alloc();
    return {content_, size_};
  }

 private:
  char* content_ = nullptr;
  std::size_t size_ = 0;
  FILE* stream_;
};

std::vector<std::uint8_t> withoutAlpha(const std::vector<Rgba8>& pixels) {
  std::vector<std::uint8_t> channels;
  channels.reserve(3 * pixels.size());
  for (const Rgba8& pixel : pixels) channels.insert(channels.end(), {pixel.r, pixel.g, pixel.b});
  return channels;
}

}  // namespace

void writePng(const std::filesystem::path& path, const Image& image) {
  if (image.width < 1 || image.height < 1)
    throw InvalidInput(
        fmt::format("{}: an image of {} x {} pixels", path.string(), image.width, image.height));
  assert(image.pixels.size() == std::size_t(image.width) * image.height);
  // Opened first: it says at once where nothing can be written.
  OutputFile file(path);

  const bool isOpaque = std::ranges::all_of(image.pixels, [](const Rgba8& pixel) { return pixel.a == 255; });
  const std::vector<std::uint8_t> opaque =
      isOpaque ? withoutAlpha(image.pixels) : std::vector<std::uint8_t>{};
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = isOpaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const void* pixels = isOpaque ? static_cast<const void*>(opaque.data()) : image.pixels.data();
  MemoryStream stream;
  if (!png_image_write_to_stdio(&png, stream.get(), 0, pixels, 0, nullptr)) {
    throw IoError(fmt::format("{}: the image cannot be encoded ({})", path.string(), png.message));
  }
  file.write(stream.content());
  file.commit();
}

}  // namespace stipple
