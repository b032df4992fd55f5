#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "tests/app/cli/cli_fixture.h"
#include "tests/support/png_picture.h"

namespace stipple {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Points at unit length on the six axes, each in a color of its own.
constexpr const char* kAxes =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
    "1 0 0 255 0 0\n0 1 0 0 255 0\n0 0 1 0 0 255\n-1 0 0 0 255 255\n0 -1 0 255 0 255\n0 0 -1 255 255 0\n";
enum class Axis { kRight, kBack, kUp, kLeft, kFront, kDown };  // x, y, z, -x, -y, -z: red, green, blue, ...

/// Three channels in two steps: light changes how bright a color is, not this.
int hueOf(const Rgba8& color) {
  const int half = std::max({color.r, color.g, color.b}) / 2;
  return (color.r > half) << 2 | (color.g > half) << 1 | static_cast<int>(color.b > half);
}

class RenderCli : public Cli {
 protected:
  // A picture without anything between pixels: every point is one of them, the background is transparent.
  Image renderAxes(const std::vector<std::string>& camera) const {
    std::vector<std::string> arguments = {"render",
                                          path("axes.ply"),
                                          "-o",
                                          path("axes.png"),
                                          "--surface",
                                          "points",
                                          "--size",
                                          "200x100",
                                          "--supersample",
                                          "1",
                                          "--background",
                                          "none",
                                          "--edges",
                                          "0",
                                          "--backend",
                                          "cpu"};
    arguments.insert(arguments.end(), camera.begin(), camera.end());
    write("axes.ply", kAxes);
    const ProgramRun done = run(arguments);
    EXPECT_EQ(done.exitCode, 0) << done.err;
    return readPng(path("axes.png")).image;
  }

  /// The point of this axis is seen within a pixel of this place.
  static void expectAt(const Image& image, Axis axis, double x, double y) {
    constexpr int kHues[] = {4, 2, 1, 3, 5, 6};
    int seen = 0;
    for (int row = 0; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
        const Rgba8& pixel = image.at(column, row);
        if (pixel.a == 0 || hueOf(pixel) != kHues[static_cast<int>(axis)]) continue;
        ++seen;
        EXPECT_NEAR(column + 0.5, x, 1.01) << static_cast<int>(axis);
        EXPECT_NEAR(row + 0.5, y, 1.01) << static_cast<int>(axis);
      }
    }
    EXPECT_GT(seen, 0) << "axis " << static_cast<int>(axis) << " is not seen";
  }

  Image renderFile(const std::string& file, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"render", file,    "-o",        path("out.png"),
                                          "--size", "64x48", "--backend", "cpu"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun done = run(arguments);
    EXPECT_EQ(done.exitCode, 0) << done.err;
    return done.exitCode == 0 ? readPng(path("out.png")).image : Image{};
  }
};

int countSeen(const Image& image) {
  return static_cast<int>(std::ranges::count_if(image.pixels, [](const Rgba8& p) { return p.a > 0; }));
}

TEST_F(RenderCli, LooksAlongYWithoutTurning) {
  const Image image = renderAxes({"--camera", "0,0,0.8", "--ortho"});
  expectAt(image, Axis::kFront, 100, 50);
  expectAt(image, Axis::kRight, 140, 50);
  expectAt(image, Axis::kLeft, 60, 50);
  expectAt(image, Axis::kUp, 100, 10);
  expectAt(image, Axis::kDown, 100, 90);
}

TEST_F(RenderCli, YawTurnsCounterclockwiseSeenFromAbove) {
  // A quarter turn: the camera looks along -x.
  const Image quarter = renderAxes({"--camera", "90,0,0.8", "--ortho"});
  expectAt(quarter, Axis::kRight, 100, 50);
  expectAt(quarter, Axis::kBack, 140, 50);
  expectAt(quarter, Axis::kUp, 100, 10);
  const Image back = renderAxes({"--camera", "-30,0,0.8", "--ortho"});
  expectAt(back, Axis::kRight, 100 + 40 * std::cos(std::numbers::pi / 6), 50);
  expectAt(back, Axis::kFront, 100 - 20, 50);
}

TEST_F(RenderCli, PitchLooksDown) {
  const Image image = renderAxes({"--camera", "0,90,0.8", "--ortho"});
  expectAt(image, Axis::kUp, 100, 50);
  expectAt(image, Axis::kBack, 100, 10);
  const Image half = renderAxes({"--camera", "0,30,0.8", "--ortho"});
  expectAt(half, Axis::kUp, 100, 50 - 40 * std::cos(std::numbers::pi / 6));
  expectAt(half, Axis::kFront, 100, 50 + 20);
}

TEST_F(RenderCli, YUpLooksAlongMinusZ) {
  const Image image = renderAxes({"--camera", "0,0,0.8", "--ortho", "--up", "y"});
  expectAt(image, Axis::kUp, 100, 50);
  expectAt(image, Axis::kRight, 140, 50);
  expectAt(image, Axis::kBack, 100, 10);
}

TEST_F(RenderCli, PerspectiveFitsTheSphere) {
  // The eye is R / sin(17.5 degrees) / zoom away from the center, half the height covers 17.5 degrees.
  const double angle = 17.5 * std::numbers::pi / 180, zoom = 0.8;
  const double distance = 1 / std::sin(angle) / zoom, focal = 50 / std::tan(angle);
  const Image image = renderAxes({"--camera", "0,0,0.8"});
  expectAt(image, Axis::kFront, 100, 50);
  expectAt(image, Axis::kRight, 100 + focal / distance, 50);
  expectAt(image, Axis::kUp, 100, 50 - focal / distance);
}

TEST_F(RenderCli, BackgroundIsOpaqueUnlessThereIsNone) {
  const std::string example = writeExample();
  const Image none = renderFile(example, {"--background", "none"});
  EXPECT_EQ(none.at(0, 0).a, 0);
  EXPECT_GT(countSeen(none), 0);
  EXPECT_EQ(renderFile(example, {"--background", "#3c0"}).at(0, 0), (Rgba8{51, 204, 0, 255}));
  EXPECT_EQ(renderFile(example, {"--background", "#010a6F"}).at(0, 0), (Rgba8{1, 10, 111, 255}));
  EXPECT_EQ(renderFile(example, {"--background", "7,0,255"}).at(0, 0), (Rgba8{7, 0, 255, 255}));
  EXPECT_EQ(renderFile(example, {"--background", "white"}).at(0, 0), (Rgba8{255, 255, 255, 255}));
  EXPECT_EQ(readPng(path("out.png")).channels, 3);
}

TEST_F(RenderCli, ReportsInJson) {
  const json report = runJson(
      {"render", writeExample(), "-o", path("out.png"), "--size", "32x20", "--backend", "cpu", "--json"});
  EXPECT_EQ(report["points"], 5);
  EXPECT_GE(report["splats"], 1);
  EXPECT_LE(report["splats"], 5);
  EXPECT_EQ(report["backend"], "cpu");
  EXPECT_EQ(report["warnings"], json::array());
  for (const char* stage : {"read", "colors", "surface", "hierarchy", "cut", "draw", "write", "total"})
    EXPECT_GE(report["seconds"][stage], 0) << stage;
  const Image image = readPng(path("out.png")).image;
  EXPECT_EQ(image.width, 32);
  EXPECT_EQ(image.height, 20);
  EXPECT_EQ(files(), (std::vector<std::string>{"example.ply", "out.png"}));
}

TEST_F(RenderCli, ThreadsAndRepetitionsChangeNothing) {
  const std::string example = writeExample();
  const Image once = renderFile(example), again = renderFile(example);
  EXPECT_EQ(once.pixels, again.pixels);
}

TEST_F(RenderCli, ShowsAttributes) {
  const std::string example = writeExample();
  const Image plain = renderFile(example);
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--color-by", "mask"},
        {"--color-by", "label"},
        {"--color-by", "label", "--colormap", "turbo"},
        {"--color-by", "mask", "--range", "-1,0.5", "--colormap", "blue-to-red"},
        {"--saturation-by", "mask"},
        {"--highlight", "label"}}) {
    EXPECT_NE(renderFile(example, more).pixels, plain.pixels) << more[0] << " " << more[1];
  }
  EXPECT_EQ(renderFile(example, {"--color-by", "color"}).pixels, plain.pixels);
}

TEST_F(RenderCli, ShowsWhatIsNotANumberInGray) {
  const std::string file =
      write("nan.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "property float heat\nend_header\n0 0 0 nan\n1 0 0 nan\n0 0 1 nan\n1 0 1 nan\n");
  const Image image = renderFile(file, {"--color-by", "heat", "--background", "none", "--camera", "0,0"});
  EXPECT_GT(countSeen(image), 10);
  for (const Rgba8& pixel : image.pixels) EXPECT_TRUE(pixel.r == pixel.g && pixel.g == pixel.b);
}

TEST_F(RenderCli, DrawsFewPointsToo) {
  const std::string header = "ply\nformat ascii 1.0\nelement vertex ";
  const std::string properties = "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  const std::string one = write("one.ply", header + "1" + properties + "5 6 7\n");
  const std::string same = write("same.ply", header + "2" + properties + "5 6 7\n5 6 7\n");
  const std::string two = write("two.ply", header + "2" + properties + "0 0 0\n1 0 0\n");
  const std::string three = write("three.ply", header + "3" + properties + "0 0 0\n1 0 0\n0 0 1\n");
  for (const std::string& file : {one, same, two, three}) {
    for (const char* surface : {"splats", "discs", "points"}) {
      for (const bool ortho : {false, true}) {
        std::vector<std::string> more = {"--background", "none", "--surface", surface};
        if (ortho) more.push_back("--ortho");
        const int seen = countSeen(renderFile(file, more));
        EXPECT_GT(seen, 0) << file << " " << surface;
        EXPECT_LT(seen, 64 * 48) << file << " " << surface;
      }
    }
  }
}

TEST_F(RenderCli, DrawsTrianglesAndGlyphs) {
  const std::string square =
      write("square.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 0 -1 0\n1 0 0 0 -1 0\n1 0 1 0 -1 0\n0 0 1 0 -1 0\n4 0 1 2 3\n");
  const std::vector<std::string> mesh = {"--surface",     "mesh", "--ortho",      "--camera", "0,0,1",
                                         "--supersample", "1",    "--background", "none"};
  const Image image = renderFile(square, mesh);
  // The square's half diagonal is half the height: its sides are 48 / sqrt(2) pixels long.
  EXPECT_NEAR(countSeen(image), 48 * 48 / 2, 100);
  EXPECT_EQ(image.at(32, 24).a, 255);
  std::vector<std::string> glyphs = mesh;
  glyphs.insert(glyphs.end(), {"--glyphs", "normal"});
  glyphs[4] = "40,30,1";
  EXPECT_NE(renderFile(square, glyphs).pixels, image.pixels);
  const json report = runJson({"render", square, "-o", path("out.png"), "--surface", "mesh", "--backend",
                               "cpu", "--size", "9x9", "--json"});
  EXPECT_EQ(report["triangles"], 2);
  EXPECT_EQ(report["splats"], 0);
  EXPECT_THAT(failWith(2, {"render", writeExample(), "-o", path("o.png"), "--surface", "mesh"}),
              HasSubstr("holds no triangles"));
}

TEST_F(RenderCli, RefusesWrongUseBeforeReading) {
  const auto refusal = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"render", path("absent.ply"), "-o", path("out.png")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return failWith(2, arguments);
  };
  for (const char* size : {"100", "0x10", "10x-1", "16385x1", "1x16385", "10x10x10", "ax1", "1.5x2", ""})
    EXPECT_THAT(refusal({"--size", size}), HasSubstr("sides from 1 to 16384")) << size;
  for (const char* camera : {"10", "1,2,3,4", "a,b", "nan,0", "1,inf", "1,,2", "1,2,", ""})
    EXPECT_THAT(refusal({"--camera", camera}), HasSubstr("YAW,PITCH")) << camera;
  EXPECT_THAT(refusal({"--camera", "0,91"}), HasSubstr("from -90 to 90"));
  EXPECT_THAT(refusal({"--camera", "0,0,0"}), HasSubstr("zoom from"));
  EXPECT_THAT(refusal({"--camera", "0,0,-1"}), HasSubstr("zoom from"));
  EXPECT_THAT(refusal({"--up", "x"}), HasSubstr("not one of y|z"));
  EXPECT_THAT(refusal({"--range", "1,1"}), HasSubstr("MIN less than MAX"));
  EXPECT_THAT(refusal({"--range", "2,1"}), HasSubstr("MIN less than MAX"));
  EXPECT_THAT(refusal({"--range", "0,nan"}), HasSubstr("MIN less than MAX"));
  EXPECT_THAT(refusal({"--colormap", "jet"}), HasSubstr("not one of viridis|turbo|blue-to-red|gray"));
  EXPECT_THAT(refusal({"--backend", "vulkan"}), HasSubstr("not one of auto|cpu|gl"));
  EXPECT_THAT(refusal({"--tau", "0"}), HasSubstr("--tau"));
  EXPECT_THAT(refusal({"--tau", "nan"}), HasSubstr("--tau"));
  EXPECT_THAT(refusal({"--supersample", "-1"}), HasSubstr("--supersample"));
  EXPECT_THAT(refusal({"--supersample", "17"}), HasSubstr("--supersample"));
  for (const char* color : {"reddish", "#12", "#12345g", "#1234567", "1,2", "256,0,0", "1,2,3,4", ""})
    EXPECT_THAT(refusal({"--background", color}), HasSubstr("#RRGGBB")) << color;
  EXPECT_THAT(refusal({"--surface", "voxels"}), HasSubstr("not one of splats|discs|points|mesh"));
  EXPECT_THAT(refusal({"--edges", "2"}), HasSubstr("--edges"));
  for (const char* option : {"--color-by", "--saturation-by", "--highlight", "--glyphs"})
    EXPECT_THAT(refusal({option, ""}), HasSubstr("the name of an attribute is empty")) << option;
  EXPECT_THAT(failWith(2, {"render", path("absent.ply")}), HasSubstr("--output is required"));
}

TEST_F(RenderCli, RefusesAttributesThatAreNotThere) {
  const std::string example = writeExample();
  for (const char* option : {"--color-by", "--saturation-by", "--highlight", "--glyphs"}) {
    EXPECT_THAT(failWith(2, {"render", example, "-o", path("out.png"), option, "warmth"}),
                HasSubstr("'warmth'"))
        << option;
  }
  EXPECT_THAT(failWith(2, {"render", example, "-o", path("out.png"), "--saturation-by", "color"}),
              HasSubstr("'color' is a color"));
  EXPECT_THAT(failWith(2, {"render", example, "-o", path("out.png"), "--glyphs", "mask"}),
              HasSubstr("'mask'"));
  EXPECT_EQ(files(), std::vector<std::string>{"example.ply"});
}

TEST_F(RenderCli, UnwritablePicturesAreExit3BeforeTheWork) {
  const std::string absent = path("absent.ply");  // would be refused, were it looked at
  EXPECT_THAT(failWith(3, {"render", absent, "-o", path("no/out.png")}), HasSubstr("no/out.png"));
  EXPECT_THAT(failWith(3, {"render", absent, "-o", folder_.string()}), HasSubstr(folder_.string()));
  EXPECT_THAT(failWith(3, {"render", absent, "-o", path("out.jpg")}), HasSubstr("ends in .png"));
  EXPECT_THAT(files(), testing::IsEmpty());
}

TEST_F(RenderCli, CtrlCIsExit130AndLeavesNothing) {
  const ProgramRun stopped = run({"render", writeExample(), "-o", path("out.png"), "--size", "2000x2000",
                                  "--supersample", "16", "--backend", "cpu", "--json"},
                                 400);
  EXPECT_EQ(stopped.exitCode, 130);
  EXPECT_EQ(stopped.out, "");
  EXPECT_EQ(countLines(stopped.err), 1);
  EXPECT_EQ(files(), std::vector<std::string>{"example.ply"});
}

}  // namespace
}  // namespace stipple
