#include <gtest/gtest.h>

#include "tests/app/cli/cli_fixture.h"
#include "tests/support/picture_errors.h"
#include "tests/support/png_picture.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

class MeshPicture : public Cli {};

// Where both cover the pixel.
TEST_F(MeshPicture, SplatsAndTrianglesOfTheBunnyShowTheSame) {
  STIPPLE_NEEDS_TEST_DATA();
  const std::string bunny = testData("smooth/bun_zipper_ascii.ply").string();
  std::vector<Image> images;
  for (const char* surface : {"splats", "mesh"}) {
    const auto png = path(std::string(surface) + ".png");
    ASSERT_EQ(run({"render", bunny, "-o", png, "--surface", surface, "--up", "y", "--camera", "20,10",
                   "--size", "640x480", "--background", "none"})
                  .exitCode,
              0);
    images.push_back(readPng(png).image);
  }
  std::vector<std::uint8_t> isCovered(images[0].pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < isCovered.size(); ++i) {
    isCovered[i] = images[0].pixels[i].a == 255 && images[1].pixels[i].a == 255;
    count += isCovered[i];
  }
  EXPECT_GT(count, 40'000u);
  const double agreement = psnr(images[0], images[1], isCovered);
  std::printf("splats and triangles: %.2f dB\n", agreement);
  EXPECT_GE(agreement, 30);
}

}  // namespace
}  // namespace stipple
