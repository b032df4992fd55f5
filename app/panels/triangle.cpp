#include "app/panels/triangle.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/panels/blend.h"

namespace stipple {

namespace {

// Beyond every picture, within int.
constexpr double kFar = 1 << 24;

int firstPixel(double x) {
  // In this order, so that a coordinate that is not a number lies far away.
  const double shifted = std::min(std::max(-kFar, x), kFar) - 0.5;
  // Rounded up by hand: without SSE 4.1 std::ceil is a call, twice for each row of each triangle.
  const int towardZero = static_cast<int>(shifted);
  return towardZero + (shifted > towardZero ? 1 : 0);
}

// From the upper to the lower end; of two on one height, from the left to the right. Two triangles that share
// an edge therefore compute the same crossings, bit for bit: no gap, nothing drawn twice.
struct Edge {
  Edge(const RasterVertex& a, const RasterVertex& b) {
    const bool isInOrder = std::pair(a.y, a.x) <= std::pair(b.y, b.x);
    const RasterVertex &upper = isInOrder ? a : b, &lower = isInOrder ? b : a;
    x0 = upper.x, y0 = upper.y;
    slope = lower.y > upper.y ? (double(lower.x) - upper.x) / (double(lower.y) - upper.y) : 0;
    std::tie(least, most) = std::minmax(double(upper.x), double(lower.x));
  }
  double crossing(double y) const { return std::clamp(x0 + (y - y0) * slope, least, most); }

  double x0, y0, slope, least, most;
};

// Calls draw(y, left, right) for each row of pixels whose centers lie in the triangle.
template <class Draw>
void forEachSpan(const RasterVertex (&corners)[3], const PixelRectangle& scissor, const Draw& draw) {
  const RasterVertex *top = &corners[0], *middle = &corners[1], *bottom = &corners[2];
  if (top->y > middle->y) std::swap(top, middle);
  if (middle->y > bottom->y) std::swap(middle, bottom);
  if (top->y > middle->y) std::swap(top, middle);
  const int begin = std::max(firstPixel(top->y), scissor.top);
  const int turn = firstPixel(middle->y);
  const int end = std::min(firstPixel(bottom->y), scissor.bottom);
  if (begin >= end) return;

  const Edge whole(*top, *bottom), upper(*top, *middle), lower(*middle, *bottom);
  const double area = (double(bottom->x) - top->x) * (double(middle->y) - top->y) -
                      (double(middle->x) - top->x) * (double(bottom->y) - top->y);
  // Neither flat nor with a coordinate that is not a number.
  if (!(area < 0 || area > 0)) return;
  const bool turnsLeft = area > 0;
  for (int y = begin; y < end; ++y) {
    const double center = y + 0.5;
    int left = firstPixel(whole.crossing(center));
    int right = firstPixel((y < turn ? upper : lower).crossing(center));
    if (turnsLeft) std::swap(left, right);
    left = std::max(left, scissor.left);
    right = std::min(right, scissor.right);
    if (left < right) draw(y, left, right);
  }
}

SourceColor colorOf(std::uint32_t word) {
  return {{std::uint8_t(word), std::uint8_t(word >> 8), std::uint8_t(word >> 16)}, std::uint8_t(word >> 24)};
}

// Bilinear, with the border repeated; texel i is centered on i + 0.5.
float sample(const AlphaTexture& atlas, float u, float v) {
  const float x = std::clamp(u - 0.5f, 0.0f, float(atlas.width - 1));
  const float y = std::clamp(v - 0.5f, 0.0f, float(atlas.height - 1));
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, atlas.width - 1), y1 = std::min(y0 + 1, atlas.height - 1);
  const std::uint8_t* upper = atlas.texels.data() + std::size_t(y0) * atlas.width;
  const std::uint8_t* lower = atlas.texels.data() + std::size_t(y1) * atlas.width;
  const float s = x - float(x0), t = y - float(y0);
  return (1 - t) * ((1 - s) * upper[x0] + s * upper[x1]) + t * ((1 - s) * lower[x0] + s * lower[x1]);
}

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f) + 0.5f);
}

// The alpha of a color under a texel.
SourceColor covered(SourceColor color, std::uint8_t coverage) {
  color.alpha = timesUnit(color.alpha, coverage);
  return color;
}

// Quantities linear in x and y, given at the corners of a triangle.
struct Plane {
  float atOrigin, dx, dy;

  float at(float x, float y) const { return atOrigin + dx * x + dy * y; }
};

class Interpolation {
 public:
  explicit Interpolation(const RasterVertex (&corners)[3])
      : x0_(corners[0].x),
        y0_(corners[0].y),
        x1_(corners[1].x - x0_),
        y1_(corners[1].y - y0_),
        x2_(corners[2].x - x0_),
        y2_(corners[2].y - y0_) {
    const float area = x1_ * y2_ - x2_ * y1_;
    scale_ = area != 0 ? 1 / area : 0;
  }

  // x and y count from the first corner, where the numbers are small.
  Plane planeOf(float a, float b, float c) const {
    return {a, ((b - a) * y2_ - (c - a) * y1_) * scale_, ((c - a) * x1_ - (b - a) * x2_) * scale_};
  }
  Plane channelOf(const RasterVertex (&corners)[3], int channel) const {
    const auto value = [&](int corner) { return float((corners[corner].color >> (8 * channel)) & 255); };
    return planeOf(value(0), value(1), value(2));
  }
  float fromX(int column) const { return float(column) + 0.5f - x0_; }
  float fromY(int row) const { return float(row) + 0.5f - y0_; }

 private:
  float x0_, y0_, x1_, y1_, x2_, y2_, scale_;
};

// Soft edges: one color, its alpha falling.
void drawFading(const RasterScene& scene, const RasterVertex (&corners)[3]) {
  const Interpolation interpolation(corners);
  const Plane alpha = interpolation.channelOf(corners, 3);
  SourceColor color = colorOf(corners[0].color);
  forEachSpan(corners, scene.scissor, [&](int row, int left, int right) {
    std::uint32_t* pixels = scene.target.row(row);
    const float y = interpolation.fromY(row);
    for (int column = left; column < right; ++column) {
      color.alpha = toByte(alpha.at(interpolation.fromX(column), y));
      blendPixel(pixels[column], color);
    }
  });
}

void drawShaded(const RasterScene& scene, const RasterVertex (&corners)[3], bool isTextured) {
  const Interpolation interpolation(corners);
  const Plane red = interpolation.channelOf(corners, 0), green = interpolation.channelOf(corners, 1),
              blue = interpolation.channelOf(corners, 2), opacity = interpolation.channelOf(corners, 3);
  const Plane u = interpolation.planeOf(corners[0].u, corners[1].u, corners[2].u);
  const Plane v = interpolation.planeOf(corners[0].v, corners[1].v, corners[2].v);
  forEachSpan(corners, scene.scissor, [&](int row, int left, int right) {
    std::uint32_t* pixels = scene.target.row(row);
    const float y = interpolation.fromY(row);
    for (int column = left; column < right; ++column) {
      const float x = interpolation.fromX(column);
      float alpha = std::clamp(opacity.at(x, y), 0.0f, 255.0f);
      if (isTextured) alpha *= sample(scene.atlas, u.at(x, y), v.at(x, y)) / 255;
      blendPixel(pixels[column],
                 {{toByte(red.at(x, y)), toByte(green.at(x, y)), toByte(blue.at(x, y))}, toByte(alpha)});
    }
  });
}

bool haveOneTexel(const RasterVertex& a, const RasterVertex& b) {
  return a.u == b.u && a.v == b.v;
}

// Rows of texels onto rows of pixels, one to one, the atlas beginning at (texelX, texelY).
struct TexelShift {
  int x = 0, y = 0;  // from pixels to texels
};

// Whether the texture lies on the pixels exactly: atlas coordinates carry a rounding error far below this.
bool findShift(float pixelFrom, float pixelTo, float texelFrom, float texelTo, int& shift) {
  constexpr float kTolerance = 1.0f / 64;
  const float exact = texelFrom - pixelFrom;
  shift = static_cast<int>(std::lround(exact));
  return std::abs(exact - float(shift)) < kTolerance && std::abs(texelTo - pixelTo - exact) < kTolerance;
}

void copyGlyph(const RasterScene& scene, const PixelRectangle& area, const SourceColor& color,
               const TexelShift& shift) {
  const AlphaTexture& atlas = scene.atlas;
  const int left = std::max(area.left, -shift.x), right = std::min(area.right, atlas.width - shift.x);
  const int top = std::max(area.top, -shift.y), bottom = std::min(area.bottom, atlas.height - shift.y);
  if (left >= right) return;
  for (int y = top; y < bottom; ++y) {
    const std::uint8_t* texels = atlas.texels.data() + std::size_t(y + shift.y) * atlas.width;
    blendCoverage(scene.target.row(y) + left, right - left, color, texels + left + shift.x);
  }
}

void stretchTexture(const RasterScene& scene, const PixelRectangle& area, const RasterVertex& a,
                    const RasterVertex& b) {
  const float du = (b.u - a.u) / (b.x - a.x), dv = (b.v - a.v) / (b.y - a.y);
  const SourceColor color = colorOf(a.color);
  for (int y = area.top; y < area.bottom; ++y) {
    std::uint32_t* pixels = scene.target.row(y);
    const float v = a.v + (float(y) + 0.5f - a.y) * dv;
    for (int x = area.left; x < area.right; ++x) {
      const float u = a.u + (float(x) + 0.5f - a.x) * du;
      blendPixel(pixels[x], covered(color, toByte(sample(scene.atlas, u, v))));
    }
  }
}

}  // namespace

int firstPixelFrom(float x) {
  return firstPixel(x);
}

void drawTriangle(const RasterScene& scene, const RasterVertex (&corners)[3]) {
  constexpr std::uint32_t kHue = 0x00ffffff;
  const auto& [a, b, c] = corners;
  if (((a.color | b.color | c.color) >> 24) == 0) return;
  if (!haveOneTexel(a, b) || !haveOneTexel(b, c)) return drawShaded(scene, corners, true);
  const std::uint8_t coverage = toByte(sample(scene.atlas, a.u, a.v));
  if (a.color == b.color && b.color == c.color) {
    const SourceColor color = covered(colorOf(a.color), coverage);
    forEachSpan(corners, scene.scissor, [&](int y, int left, int right) {
      blendSpan(scene.target.row(y) + left, right - left, color);
    });
  } else if (coverage == 255 && ((a.color ^ b.color) & kHue) == 0 && ((b.color ^ c.color) & kHue) == 0) {
    drawFading(scene, corners);
  } else {
    drawShaded(scene, corners, coverage != 255);
  }
}

void drawRectangle(const RasterScene& scene, const RasterVertex& a, const RasterVertex& b) {
  if ((a.color >> 24) == 0) return;
  const PixelRectangle area{.left = std::max(firstPixel(a.x), scene.scissor.left),
                            .top = std::max(firstPixel(a.y), scene.scissor.top),
                            .right = std::min(firstPixel(b.x), scene.scissor.right),
                            .bottom = std::min(firstPixel(b.y), scene.scissor.bottom)};
  if (area.isEmpty()) return;
  TexelShift shift;
  if (haveOneTexel(a, b)) {
    const SourceColor color = covered(colorOf(a.color), toByte(sample(scene.atlas, a.u, a.v)));
    for (int y = area.top; y < area.bottom; ++y) {
      blendSpan(scene.target.row(y) + area.left, area.width(), color);
    }
  } else if (findShift(a.x, b.x, a.u, b.u, shift.x) && findShift(a.y, b.y, a.v, b.v, shift.y)) {
    copyGlyph(scene, area, colorOf(a.color), shift);
  } else {
    stretchTexture(scene, area, a, b);
  }
}

}  // namespace stipple
