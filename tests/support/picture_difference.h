#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "render/appearance/image.h"

namespace stipple {

/// How far two pictures of one size are apart.
struct PictureDifference {
  double mean = 0;    ///< of a channel, of 255
  double within = 1;  ///< share of the pixels whose channels all differ by at most 8
};

inline PictureDifference differenceOf(const Image& a, const Image& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  double sum = 0;
  std::size_t within = 0;
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
    const Rgba8 &p = a.pixels[i], &q = b.pixels[i];
    const std::array<int, 4> off = {std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b),
                                    std::abs(p.a - q.a)};
    sum += off[0] + off[1] + off[2] + off[3];
    within += *std::ranges::max_element(off) <= 8;
  }
  const auto pixels = static_cast<double>(a.pixels.size());
  return {.mean = sum / 4 / pixels, .within = static_cast<double>(within) / pixels};
}

/// The bar for two back ends.
inline void expectSamePicture(const std::string& what, const Image& a, const Image& b) {
  const PictureDifference difference = differenceOf(a, b);
  EXPECT_LT(difference.mean, 1) << what;
  EXPECT_GE(difference.within, 0.999) << what;
}

}  // namespace stipple
