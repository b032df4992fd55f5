#include "tests/support/picture_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "render/splat/renderer.h"

namespace stipple {

namespace {

using Mask = std::vector<std::uint8_t>;

/// Largest (or smallest) value of each pixel and its neighbors; `outside` stands beyond the border.
template <class T, class Better>
std::vector<T> extremeOfNeighbors(const std::vector<T>& values, int width, int height, T outside,
                                  Better better) {
  std::vector<T> result(values.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      T best = values[static_cast<std::size_t>(y) * width + x];
      for (int v = y - 1; v <= y + 1; ++v) {
        for (int u = x - 1; u <= x + 1; ++u) {
          const bool isInside = u >= 0 && v >= 0 && u < width && v < height;
          const T value = isInside ? values[static_cast<std::size_t>(v) * width + u] : outside;
          if (better(value, best)) best = value;
        }
      }
      result[static_cast<std::size_t>(y) * width + x] = best;
    }
  }
  return result;
}

float luma(const Rgba8& c) {
  return 0.299f * c.r + 0.587f * c.g + 0.114f * c.b;
}

constexpr int kWindow = 11, kHalf = kWindow / 2;

std::array<double, kWindow> gaussian() {
  std::array<double, kWindow> weights{};
  double sum = 0;
  for (int i = 0; i < kWindow; ++i) sum += weights[i] = std::exp(-0.5 * std::pow((i - kHalf) / 1.5, 2));
  for (double& w : weights) w /= sum;
  return weights;
}

/// Similarity of the windows about (x, y); nothing where one leaves the mask.
std::optional<double> windowSimilarity(const Image& a, const Image& b, const Mask& mask, int x, int y) {
  static const std::array<double, kWindow> kWeights = gaussian();
  double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (int v = 0; v < kWindow; ++v) {
    for (int u = 0; u < kWindow; ++u) {
      const std::size_t pixel = static_cast<std::size_t>(y + v - kHalf) * a.width + (x + u - kHalf);
      if (!mask[pixel]) return std::nullopt;
      const double w = kWeights[u] * kWeights[v], p = luma(a.pixels[pixel]), q = luma(b.pixels[pixel]);
      ma += w * p;
      mb += w * q;
      aa += w * p * p;
      bb += w * q * q;
      ab += w * p * q;
    }
  }
  constexpr double kC1 = 6.5025, kC2 = 58.5225;  // (0.01 * 255)^2 and (0.03 * 255)^2
  return (2 * ma * mb + kC1) * (2 * (ab - ma * mb) + kC2) /
         ((ma * ma + mb * mb + kC1) * (aa - ma * ma + bb - mb * mb + kC2));
}

template <class Term>
double meanOverChannels(const Image& a, const Image& b, const Mask& mask, Term term) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const Rgba8 p = a.pixels[i], q = b.pixels[i];
    sum += term(p.r - q.r) + term(p.g - q.g) + term(p.b - q.b);
    count += 3;
  }
  return count ? sum / static_cast<double>(count) : 0;
}

}  // namespace

DrawnPicture takePicture(Renderer& renderer) {
  DrawnPicture picture{renderer.image(), {}};
  picture.depth.reserve(picture.image.pixels.size());
  for (int y = 0; y < picture.image.height; ++y) {
    for (int x = 0; x < picture.image.width; ++x) {
      const std::optional<Pick> pick = renderer.pick(x, y);
      picture.depth.push_back(pick ? pick->depth : kNoDepth);
    }
  }
  return picture;
}

Mask dilate(const Mask& mask, int width, int height) {
  return extremeOfNeighbors<std::uint8_t>(mask, width, height, 0, std::greater<>());
}

Mask erode(const Mask& mask, int width, int height) {
  return extremeOfNeighbors<std::uint8_t>(mask, width, height, 0, std::less<>());
}

double psnr(const Image& a, const Image& b, const Mask& mask) {
  const double error = meanOverChannels(a, b, mask, [](int d) { return double(d) * d; });
  return error == 0 ? 99 : 10 * std::log10(255.0 * 255.0 / error);
}

double meanDifference(const Image& a, const Image& b, const Mask& mask) {
  return meanOverChannels(a, b, mask, [](int d) { return double(std::abs(d)); });
}

double ssim(const Image& a, const Image& b, const Mask& mask) {
  struct Sum {
    double value = 0;
    std::size_t windows = 0;
  };
  std::vector<Sum> rows(static_cast<std::size_t>(std::max(a.height, 0)));
  parallelFor(rows.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      if (y < kHalf || y >= a.height - kHalf) continue;
      for (int x = kHalf; x < a.width - kHalf; ++x) {
        if (const auto similarity = windowSimilarity(a, b, mask, x, y)) {
          rows[y].value += *similarity;
          ++rows[y].windows;
        }
      }
    }
  });
  Sum all;
  for (const Sum& row : rows) all = {all.value + row.value, all.windows + row.windows};
  return all.windows ? all.value / static_cast<double>(all.windows)
                     : std::numeric_limits<double>::quiet_NaN();
}

PictureErrors comparePictures(const ReferencePicture& reference, const DrawnPicture& drawn,
                              float depthTolerance) {
  const int width = reference.image.width, height = reference.image.height;
  const std::size_t pixels = drawn.depth.size();
  Mask covered(pixels), touched(pixels), either(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    covered[i] = reference.isCovered(i) && reference.depth[i] != kNoDepth;
    touched[i] = reference.hits[i] > 0 || reference.depth[i] != kNoDepth;
    either[i] = touched[i] || drawn.depth[i] != kNoDepth;
  }
  const Mask inner = erode(covered, width, height), outer = dilate(touched, width, height);
  const std::vector<float> farthest =
      extremeOfNeighbors<float>(reference.depth, width, height, kNoDepth, std::greater<>());

  PictureErrors errors{.psnr = psnr(reference.image, drawn.image, covered),
                       .psnrWithEdges = psnr(reference.image, drawn.image, either),
                       .ssim = ssim(reference.image, drawn.image, covered)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const bool isDrawn = drawn.depth[i] != kNoDepth;
    errors.covered += covered[i];
    errors.holes += inner[i] && !isDrawn;
    errors.fringe += !outer[i] && isDrawn;
    errors.seeThrough += inner[i] && isDrawn && drawn.depth[i] > farthest[i] + depthTolerance;
  }
  return errors;
}

}  // namespace stipple
