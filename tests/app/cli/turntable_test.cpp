#include <nlohmann/json.hpp>

#include "tests/app/cli/cli_fixture.h"
#include "tests/support/png_picture.h"

namespace stipple {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

TEST_F(Cli, TurntableNumbersTheFramesOfOneTurn) {
  const std::string example = writeExample();
  const json report = runJson({"turntable", example, "-o", path("around"), "--frames", "4", "--size", "40x30",
                               "--camera", "10,20,0.7", "--backend", "cpu", "--json"});
  EXPECT_EQ(report["frames"], 4);
  EXPECT_EQ(report["points"], 5);
  EXPECT_EQ(report["backend"], "cpu");
  EXPECT_GE(report["seconds"]["draw"], 0);
  EXPECT_THAT(namesIn(path("around")),
              ElementsAre("frame_0000.png", "frame_0001.png", "frame_0002.png", "frame_0003.png"));
  for (int quarter = 0; quarter < 4; ++quarter) {
    // Each is the picture of a camera that was turned by a quarter more.
    const std::string camera = std::to_string(10 + 90 * quarter) + ",20,0.7";
    EXPECT_EQ(run({"render", example, "-o", path("one.png"), "--size", "40x30", "--camera", camera,
                   "--backend", "cpu"})
                  .exitCode,
              0);
    const Image frame =
        readPng(fs::path(path("around")) / ("frame_000" + std::to_string(quarter) + ".png")).image;
    const Image alone = readPng(path("one.png")).image;
    int different = 0;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
      const Rgba8 &a = frame.pixels[i], &b = alone.pixels[i];
      different += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 6;
    }
    EXPECT_LE(different, 3) << quarter;
  }
}

TEST_F(Cli, TurntableUsesAFolderThatIsThere) {
  fs::create_directory(path("around"));
  write("around/notes.txt", "kept");
  EXPECT_EQ(
      run({"turntable", writeExample(), "-o", path("around/"), "--frames", "1", "--size", "8x8"}).exitCode,
      0);
  EXPECT_THAT(namesIn(path("around")), ElementsAre("frame_0000.png", "notes.txt"));
}

TEST_F(Cli, TurntableRefusesBeforeTheWork) {
  const std::string absent = path("absent.ply"), file = write("file", "");
  EXPECT_THAT(failWith(3, {"turntable", absent, "-o", path("no/around")}), HasSubstr("no/around"));
  EXPECT_THAT(failWith(3, {"turntable", absent, "-o", file}), HasSubstr("is not a folder"));
  EXPECT_THAT(failWith(2, {"turntable", absent, "-o", path("around"), "--frames", "0"}),
              HasSubstr("--frames"));
  EXPECT_THAT(failWith(2, {"turntable", absent}), HasSubstr("--output is required"));
  EXPECT_EQ(files(), std::vector<std::string>{"file"});
}

}  // namespace
}  // namespace stipple
