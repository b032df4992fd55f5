#include "core/io/point_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/io/read_from_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using testing::UnorderedElementsAre;

ReadResult read(const std::filesystem::path& path) {
  Progress progress;
  return readPoints(path, progress);
}

std::vector<std::string> write(const std::filesystem::path& path, const PointSet& points) {
  Progress progress;
  return writePoints(path, points, {}, progress);
}

template <class Failure, class Action>
std::string messageOf(Action action) {
  try {
    action();
  } catch (const Failure& error) {
    return error.what();
  }
  return {};
}

TEST(PointIo, MissingFilesAndDirectoriesAreIoErrors) {
  const TemporaryFolder folder;
  EXPECT_EQ(messageOf<IoError>([&] { read(folder / "gone.ply"); }),
            (folder / "gone.ply").string() + ": there is no such file");
  EXPECT_THAT(messageOf<IoError>([&] { read(folder.path()); }), HasSubstr("is a directory"));
  EXPECT_THAT(messageOf<IoError>([&] { read("/dev/zero"); }), HasSubstr("not a regular file"));
}

TEST(PointIo, ContentDecidesTheFormatNotTheName) {
  EXPECT_EQ(readFromText("a.obj", "OFF\n1 0 0\n1 2 3\n").points.size(), 1u);
  EXPECT_EQ(readFromText("a.off", "v 1 2 3\nv 4 5 6\n").points.size(), 2u);
  EXPECT_EQ(readFromText("a.ply", "1 2 3\n4 5 6\n7 8 9\n").points.size(), 3u);
  EXPECT_EQ(readFromText("noname", "# text\n1 2 3\n").points.size(), 1u);
  EXPECT_EQ(readFromText("a.xyz",
                         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                         "property float z\nend_header\n1 2 3\n")
                .points.size(),
            1u);
}

// Three points, and a triangle where the format has them.
constexpr std::pair<const char*, const char*> kSmallFiles[] = {
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
     "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"a.xyz", "0 0 0\n1 0 0\n0 1 0\n"},
    {"a.csv", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n"},
    {"a.pts", "3\n0 0 0\n1 0 0\n0 1 0\n"}};

TEST(PointIo, ByteOrderMarksAndTheLineEndsOfOldMacsChangeNothing) {
  for (const auto& [name, content] : kSmallFiles) {
    const auto expected = readFromText(name, content);
    ASSERT_EQ(expected.points.size(), 3u) << name;
    std::string mac = content;
    std::ranges::replace(mac, '\n', '\r');
    for (const std::string& same : {std::string("\xEF\xBB\xBF") + content, mac}) {
      const auto result = readFromText(name, same);
      EXPECT_TRUE(
          sameBits(result.points.positionColumn().values(), expected.points.positionColumn().values()))
          << name;
      EXPECT_TRUE(result.points.triangles() == expected.points.triangles()) << name;
      EXPECT_TRUE(result.points.attributes().empty()) << name;
      EXPECT_THAT(result.warnings, IsEmpty()) << name;
    }
  }
}

TEST(PointIo, KnownKindsThatAreNotReadSayWhatToConvertThemTo) {
  std::string las = "LASF" + std::string(300, '\0'), laz = las;
  laz[104] = static_cast<char>(0x83);
  std::string stl(84 + 50, '\0');
  stl[80] = 1;
  for (const auto& [content, kind] :
       std::vector<std::pair<std::string, std::string>>{{"# .PCD v0.7\n", "PCD"},
                                                        {las, "a LAS file"},
                                                        {laz, "LAZ"},
                                                        {"ASTM-E57\1", "E57"},
                                                        {"glTF\2", "glTF"},
                                                        {"{\"asset\":{}}", "glTF"},
                                                        {"QSplat11", "QSplat"},
                                                        {"solid a\nfacet normal 0 0 1\n", "STL"},
                                                        {stl, "STL"}}) {
    EXPECT_THAT(errorOfText("a.bin", content),
                AllOf(StartsWith("a.bin: "), HasSubstr(kind), HasSubstr("convert it to")));
  }
}

TEST(PointIo, RealFilesOfOtherKindsSayTheirKind) {
  STIPPLE_NEEDS_TEST_DATA();
  for (const auto& [name, kind] :
       std::vector<std::pair<std::string, std::string>>{{"colour/fragment_binary.pcd", "PCD"},
                                                        {"formats/bunny_v05_ascii.pcd", "PCD"},
                                                        {"formats/simple.las", "a LAS file"},
                                                        {"formats/autzen_trim.laz", "LAZ"},
                                                        {"colour/lion_takanawa.copc.laz", "LAZ"},
                                                        {"formats/bunnyDouble.e57", "E57"}}) {
    EXPECT_THAT(messageOf<InvalidInput>([&] { read(testData(name)); }), HasSubstr(kind)) << name;
  }
}

TEST(PointIo, UnknownContentIsInvalidInput) {
  EXPECT_EQ(errorOfText("a.ply", ""), "a.ply: is empty");
  EXPECT_THAT(errorOfText("a.ply", "\x89PNG\r\n"), HasSubstr("of no kind that is known"));
  EXPECT_THAT(errorOfText("a.xyz", std::string("\0\1\2", 3)), HasSubstr("of no kind that is known"));
}

TEST(PointIo, NamesThatAskForNoFormatAreInvalidInput) {
  const TemporaryFolder folder;
  const PointSet points(std::vector<Eigen::Vector3f>{{1, 2, 3}});
  EXPECT_THAT(messageOf<InvalidInput>([&] { write(folder / "a.what", points); }),
              HasSubstr(".ply, .off, .obj"));
  EXPECT_THAT(messageOf<InvalidInput>([&] { write(folder / "a.las", points); }),
              HasSubstr("LAS is not written"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

PointSet everything() {
  PointSet points({{0.1F, -2.5e-7F, 3}, {1.0F / 3, 1e10F, -0.0F}, {7, 8, 9}});
  points.set("normal", std::vector<Eigen::Vector3f>{{0, 0, 1}, {0.6F, 0.8F, 0}, {1, 0, 0}});
  points.set("color", std::vector<Rgba8>{{0, 128, 255, 255}, {1, 2, 3, 255}, {254, 253, 77, 255}});
  points.set("heat", std::vector<float>{0.1F, 0.2F, 0.3F});
  points.setTriangles({{0, 1, 2}});
  return points;
}

// What each format holds comes back with the same bits, what it does not hold is named.
TEST(PointIo, TextFormatsKeepTheBitsOfWhatTheyHold) {
  const TemporaryFolder folder;
  const PointSet points = everything();
  const struct {
    const char* name;
    std::vector<std::string> kept;
    std::size_t losses;
    bool triangles;
  } kFormats[] = {{"a.obj", {"normal", "color"}, 1, true},
                  {"a.off", {"normal", "color"}, 1, true},
                  {"a.xyz", {"color", "normal"}, 2, false},
                  {"a.pwn", {"normal"}, 3, false},
                  {"a.pts", {"color"}, 3, false},
                  {"a.txt", {"normal", "color", "heat"}, 1, false},
                  {"a.asc", {"normal", "color", "heat"}, 1, false},
                  {"a.csv", {"normal", "color", "heat"}, 1, false}};
  for (const auto& format : kFormats) {
    SCOPED_TRACE(format.name);
    EXPECT_EQ(write(folder / format.name, points).size(), format.losses);
    const PointSet back = read(folder / format.name).points;
    EXPECT_TRUE(sameBits(points.positionColumn().values(), back.positionColumn().values()));
    EXPECT_EQ(back.attributes().size(), format.kept.size());
    for (const std::string& name : format.kept) {
      ASSERT_TRUE(back.has(name)) << name;
      EXPECT_TRUE(sameBits(points.find(name)->column.values(), back.find(name)->column.values())) << name;
    }
    EXPECT_EQ(back.triangles().size(), format.triangles ? 1u : 0u);
  }
}

TEST(PointIo, LossesAreNamed) {
  const TemporaryFolder folder;
  PointSet points = everything();
  points.edit<Rgba8>("color")[0].a = 7;
  EXPECT_THAT(write(folder / "a.xyz", points),
              UnorderedElementsAre(HasSubstr("'heat'"), HasSubstr("1 triangles"), HasSubstr("opacity")));
}

TEST(PointIo, ColumnsOfTextHaveNamesThatTheReaderTellsApart) {
  const TemporaryFolder folder;
  PointSet points(std::vector<Eigen::Vector3f>{{1, 2, 3}});
  float value = 0;
  for (const char* name : {"X", "a b", "a,b", "\"", "heat"}) points.set(name, std::vector<float>{++value});
  EXPECT_THAT(write(folder / "a.csv", points),
              ElementsAre(HasSubstr("'X' is written as 'X_'"), HasSubstr("'a_b' is written as 'a_b_'")));
  const PointSet back = read(folder / "a.csv").points;
  value = 0;
  for (const char* name : {"X_", "a_b", "a_b_", "_", "heat"}) {
    EXPECT_THAT(back.values<float>(name), ElementsAre(++value)) << name;
  }
}

TEST(PointIo, EveryByteOfColorSurvivesObj) {
  const TemporaryFolder folder;
  std::vector<Eigen::Vector3f> positions(256);
  std::vector<Rgba8> colors(256);
  for (int i = 0; i < 256; ++i) {
    positions[static_cast<std::size_t>(i)] = Eigen::Vector3f(static_cast<float>(i), 0, 0);
    const auto level = static_cast<std::uint8_t>(i);
    colors[static_cast<std::size_t>(i)] = {level, level, level};
  }
  PointSet points(positions);
  points.set("color", colors);
  write(folder / "a.obj", points);
  EXPECT_THAT(read(folder / "a.obj").points.values<Rgba8>("color"), testing::ElementsAreArray(colors));
}

class CancelAtOnce : public Progress {
 public:
  bool cancelled() const override { return true; }
};

TEST(PointIo, CancellingLeavesNoFile) {
  const TemporaryFolder folder;
  CancelAtOnce progress;
  EXPECT_THROW(writePoints(folder / "a.ply", everything(), {}, progress), Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  write(folder / "b.ply", everything());
  EXPECT_THROW(readPoints(folder / "b.ply", progress), Cancelled);
}

}  // namespace
}  // namespace stipple
