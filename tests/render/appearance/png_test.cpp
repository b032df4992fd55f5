#include "render/appearance/png.h"

#include <gmock/gmock.h>

#include "core/io/texture.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/png_picture.h"

namespace stipple {
namespace {

Image checkered(int width, int height, std::uint8_t alpha) {
  Image image{width, height, std::vector<Rgba8>(static_cast<std::size_t>(width) * height)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = {std::uint8_t(x * 37), std::uint8_t(y * 11), std::uint8_t(x ^ y),
                        (x + y) % 3 == 0 ? alpha : std::uint8_t{255}};
    }
  }
  return image;
}

TEST(WritePng, KeepsEveryPixelWithAlpha) {
  const TemporaryFolder folder;
  for (const std::uint8_t alpha : {0, 1, 254}) {
    const Image image = checkered(33, 17, alpha);
    writePng(folder / "a.png", image);
    const PngPicture read = readPng(folder / "a.png");
    EXPECT_EQ(read.channels, 4);
    EXPECT_EQ(read.image.width, 33);
    EXPECT_EQ(read.image.height, 17);
    EXPECT_EQ(read.image.pixels, image.pixels);
  }
}

TEST(WritePng, LeavesAlphaOutWhereAllIsOpaque) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), {1, 300}, {301, 2}}) {
    const Image image = checkered(width, height, 255);
    writePng(folder / "a.png", image);
    const PngPicture read = readPng(folder / "a.png");
    EXPECT_EQ(read.channels, 3);
    EXPECT_EQ(read.image.pixels, image.pixels);
  }
}

TEST(WritePng, IsReadAsATexture) {
  const TemporaryFolder folder;
  const Image image = checkered(4, 4, 255);
  writePng(folder / "a.png", image);
  const Texture texture(folder / "a.png");
  const Eigen::Vector3f topLeft = texture.sample(0.125F, 0.875F),
                        bottomRight = texture.sample(0.875F, 0.125F);
  const auto channels = [](const Rgba8& c) { return Eigen::Vector3f(c.r, c.g, c.b); };
  EXPECT_TRUE(topLeft.isApprox(channels(image.at(0, 0))) || topLeft.norm() < 1e-3F);
  EXPECT_TRUE(bottomRight.isApprox(channels(image.at(3, 3)), 1e-3F));
}

TEST(WritePng, ReplacesAFileWholeOrNotAtAll) {
  const TemporaryFolder folder;
  writePng(folder / "a.png", checkered(5, 5, 255));
  const std::string before = contentOf(folder / "a.png");
  EXPECT_THROW(writePng(folder / "a.png", Image{}), InvalidInput);
  EXPECT_EQ(contentOf(folder / "a.png"), before);
  EXPECT_THROW(writePng(folder / "no", Image{}), InvalidInput);
  EXPECT_THROW(writePng(folder.path(), checkered(5, 5, 255)), IoError);
  EXPECT_THROW(writePng(folder / "no" / "a.png", checkered(5, 5, 255)), IoError);
  writePng(folder / "a.png", checkered(6, 5, 255));
  EXPECT_EQ(readPng(folder / "a.png").image.width, 6);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "nothing beside it";
}

TEST(WritePng, AFullDiskIsAnIoError) {
  EXPECT_THROW(writePng("/dev/full", checkered(64, 64, 255)), IoError);
}

}  // namespace
}  // namespace stipple
