#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace stipple {

/// [left, right) x [top, bottom), in pixels.
struct PixelRectangle {
  int left = 0, top = 0, right = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool isEmpty() const { return left >= right || top >= bottom; }
  friend bool operator==(const PixelRectangle&, const PixelRectangle&) = default;
};

/// Order of the channels in memory: stipple::Image is kRgba, 32-bit pictures of window systems are kBgra.
enum class ChannelOrder { kRgba, kBgra };

/// A picture to draw onto: rows from the top, 8 bits a channel, opaque or with premultiplied alpha.
struct PixelTarget {
  std::span<std::uint32_t> pixels;
  int width = 0, height = 0;
  std::size_t stride = 0;  ///< pixels from one row to the next
  ChannelOrder order = ChannelOrder::kBgra;

  std::uint32_t* row(int y) const { return pixels.data() + static_cast<std::size_t>(y) * stride; }
};

/// Coverage of glyphs and lines, one byte a texel, rows from the top.
struct AlphaTexture {
  std::span<const std::uint8_t> texels;
  int width = 0, height = 0;
};

}  // namespace stipple
