#include "tests/support/picture_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stipple {
namespace {

Image gray(int side, int value) {
  const auto v = static_cast<std::uint8_t>(value);
  return {side, side, std::vector<Rgba8>(static_cast<std::size_t>(side) * side, Rgba8{v, v, v, 255})};
}

/// The surface covers the square [8, 24) x [8, 24) of 32 x 32 pixels at depth 5.
ReferencePicture squareReference() {
  ReferencePicture reference{.image = gray(32, 100),
                             .hits = std::vector<std::uint8_t>(1024),
                             .samples = 4,
                             .depth = std::vector<float>(1024, kNoDepth),
                             .normals = {}};
  for (int y = 8; y < 24; ++y) {
    for (int x = 8; x < 24; ++x) {
      reference.hits[y * 32 + x] = 4;
      reference.depth[y * 32 + x] = 5;
    }
  }
  return reference;
}

TEST(PictureErrors, OfTheSamePictureAreNone) {
  const ReferencePicture reference = squareReference();
  const PictureErrors errors = comparePictures(reference, {reference.image, reference.depth}, 0.1f);
  EXPECT_EQ(errors.psnr, 99);
  EXPECT_EQ(errors.ssim, 1);
  EXPECT_EQ(errors.covered, 256);
  EXPECT_EQ(errors.holes + errors.fringe + errors.seeThrough, 0);
}

TEST(PictureErrors, PsnrOfAConstantDifference) {
  const ReferencePicture reference = squareReference();
  const PictureErrors errors = comparePictures(reference, {gray(32, 110), reference.depth}, 0.1f);
  EXPECT_NEAR(errors.psnr, 20 * std::log10(25.5), 1e-9);
  // Means differ, variances are 0: only the first factor of the similarity counts.
  EXPECT_NEAR(errors.ssim, (2 * 100 * 110 + 6.5025) / (100 * 100 + 110 * 110 + 6.5025), 1e-6);
}

TEST(PictureErrors, HolesFringeAndSeeThroughHaveAMarginOfOnePixel) {
  const ReferencePicture reference = squareReference();
  DrawnPicture drawn{reference.image, reference.depth};
  drawn.depth[8 * 32 + 8] = kNoDepth;    // at the silhouette: no hole
  drawn.depth[12 * 32 + 12] = kNoDepth;  // a hole
  drawn.depth[8 * 32 + 7] = 5;           // one pixel beyond: no fringe
  drawn.depth[8 * 32 + 6] = 5;           // fringe
  drawn.depth[13 * 32 + 12] = 5.05f;     // within the tolerance
  drawn.depth[14 * 32 + 12] = 5.2f;      // the back shows
  const PictureErrors errors = comparePictures(reference, drawn, 0.1f);
  EXPECT_EQ(errors.holes, 1);
  EXPECT_EQ(errors.fringe, 1);
  EXPECT_EQ(errors.seeThrough, 1);
}

}  // namespace
}  // namespace stipple
