#include "core/io/ply_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "tests/core/io/read_from_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* kXyz = "property float x\nproperty float y\nproperty float z\n";

std::string asciiPly(const std::string& header, const std::string& rows) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + rows;
}

template <class T>
std::string bytesOf(std::initializer_list<T> values, bool bigEndian = false) {
  std::string bytes;
  for (T value : values) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (bigEndian) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
  }
  return bytes;
}

ReadResult readFile(const std::string& relative) {
  Progress progress;
  return readPoints(testData(relative), progress);
}

TEST(PlyReader, ReadsAsciiPoints) {
  const auto result =
      readFromText("a.ply", asciiPly(std::string("element vertex 2\n") + kXyz, "1 2 3\n-4 5e-1 +6\n"));
  EXPECT_THAT(result.points.positions(), ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(-4, 0.5F, 6)));
  EXPECT_EQ(result.points.positionFileType(), ScalarType::kFloat32);
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(PlyReader, FirstDataByteMayBeALineFeed) {
  // 0x0A as the first byte of x: the float 0x0000000A is 10 times the smallest denormal.
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + std::string(kXyz);
  for (const char* end : {"end_header\n", "end_header\r\n"}) {
    const std::string row("\x0a\0\0\0", 4);
    const auto result = readFromText("a.ply", head + end + row + bytesOf<float>({2, 3}));
    EXPECT_EQ(result.points.positions()[0].x(), 10 * std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(result.points.positions()[0].z(), 3);
  }
}

TEST(PlyReader, UnderstandsCarriageReturnsTabsIndentationAndComments) {
  const auto result = readFromText(
      "a.ply",
      "ply\r\nformat\tascii 1.0\r\ncomment element vertex 7\nobj_info x\r\n\n  element   vertex "
      "2\r\n\tproperty float32 x\r\n"
      "property float64 y\nproperty  int z\r\nend_header\n\r\n1 2 3\r\ncomment in the data\n\n4\t5  6  \r\n");
  EXPECT_THAT(result.points.positions(), ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)));
}

TEST(PlyReader, SkipsElementsBeforeTheVerticesAndListsInsideThem) {
  const std::string head =
      "element camera 1\nproperty list uint8 double k\nproperty short s\nelement vertex 2\nproperty list "
      "ushort uchar "
      "weights\n" +
      std::string(kXyz) + "property list char int more\nproperty uchar label\nend_header\n";
  const auto binary = [&](bool big) {
    std::string bytes =
        bytesOf<std::uint8_t>({2}) + bytesOf<double>({1, 2}, big) + bytesOf<std::int16_t>({-1}, big);
    bytes += bytesOf<std::uint16_t>({3}, big) + "abc" + bytesOf<float>({1, 2, 3}, big) +
             bytesOf<std::int8_t>({1}) + bytesOf<std::int32_t>({9}, big) + bytesOf<std::uint8_t>({200});
    bytes += bytesOf<std::uint16_t>({0}, big) + bytesOf<float>({4, 5, 6}, big) + bytesOf<std::int8_t>({0}) +
             bytesOf<std::uint8_t>({7});
    return bytes;
  };
  const std::vector<std::string> files = {
      "ply\nformat ascii 1.0\n" + head + "2 1 2 -1\n3 97 98 99 1 2 3 1 9 200\n0 4 5 6 0 7\n",
      "ply\nformat binary_little_endian 1.0\n" + head + binary(false),
      "ply\nformat binary_big_endian 1.0\n" + head + binary(true)};
  for (const std::string& file : files) {
    const auto result = readFromText("a.ply", file);
    EXPECT_THAT(result.points.positions(), ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)));
    EXPECT_THAT(result.points.values<std::uint32_t>("label"), ElementsAre(200u, 7u));
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("weights"), HasSubstr("more")));
  }
}

TEST(PlyReader, KeepsEveryNumberTypeInAllEncodings) {
  const std::string head =
      "element vertex 1\n" + std::string(kXyz) +
      "property char a\nproperty uchar b\nproperty short c\nproperty ushort d\nproperty int e\n"
      "property uint f\nproperty float g\nproperty double h\nend_header\n";
  const auto binary = [](bool big) {
    return bytesOf<float>({1, 2, 3}, big) + bytesOf<std::int8_t>({-128}) + bytesOf<std::uint8_t>({255}) +
           bytesOf<std::int16_t>({-32768}, big) + bytesOf<std::uint16_t>({65535}, big) +
           bytesOf<std::int32_t>({-2147483647 - 1}, big) + bytesOf<std::uint32_t>({4294967295u}, big) +
           bytesOf<float>({0.1F}, big) + bytesOf<double>({0.1}, big);
  };
  for (const std::string& file :
       {"ply\nformat ascii 1.0\n" + head + "1 2 3 -128 255 -32768 65535 -2147483648 4294967295 0.1 0.1\n",
        "ply\nformat binary_little_endian 1.0\n" + head + binary(false),
        "ply\nformat binary_big_endian 1.0\n" + head + binary(true)}) {
    const PointSet points = readFromText("a.ply", file).points;
    EXPECT_EQ(points.values<std::int32_t>("a")[0], -128);
    EXPECT_EQ(points.values<std::uint32_t>("b")[0], 255u);
    EXPECT_EQ(points.values<std::int32_t>("c")[0], -32768);
    EXPECT_EQ(points.values<std::uint32_t>("d")[0], 65535u);
    EXPECT_EQ(points.values<std::int32_t>("e")[0], std::numeric_limits<std::int32_t>::min());
    EXPECT_EQ(points.values<std::uint32_t>("f")[0], 4294967295u);
    EXPECT_EQ(points.values<float>("g")[0], 0.1F);
    EXPECT_EQ(points.values<double>("h")[0], 0.1);
    EXPECT_EQ(points.find("c")->file.type, ScalarType::kInt16);
  }
}

TEST(PlyReader, ColorsOfEverySpelling) {
  const auto colorOf = [](const std::string& properties, const std::string& values) {
    return readFromText("a.ply", asciiPly("element vertex 1\n" + std::string(kXyz) + properties,
                                          "0 0 0 " + values + "\n"))
        .points.values<Rgba8>("color")[0];
  };
  EXPECT_EQ(colorOf("property uchar red\nproperty uchar green\nproperty uchar blue\n", "1 2 255"),
            (Rgba8{1, 2, 255}));
  EXPECT_EQ(colorOf("property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n",
                    "1 2 3"),
            (Rgba8{1, 2, 3}));
  EXPECT_EQ(colorOf("property uchar r\nproperty uchar g\nproperty uchar b\nproperty uchar a\n", "1 2 3 4"),
            (Rgba8{1, 2, 3, 4}));
  EXPECT_EQ(colorOf("property float red\nproperty float green\nproperty float blue\n", "1 0.2 0"),
            (Rgba8{255, 51, 0}));
  EXPECT_EQ(colorOf("property ushort red\nproperty ushort green\nproperty ushort blue\n", "65535 257 0"),
            (Rgba8{255, 1, 0}));
  // 0.5 + 0.28209479 f = 1, 0.5, 0.
  EXPECT_EQ(colorOf("property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n",
                    "1.7724539 0 -1.7724539"),
            (Rgba8{255, 128, 0}));
}

TEST(PlyReader, NamesOfAttributes) {
  const PointSet points =
      readFromText(
          "a.ply",
          asciiPly("element vertex 1\n" + std::string(kXyz) +
                       "property float scalar_heat\nproperty float scalar_label\nproperty int label\n"
                       "property float nx\nproperty float ny\nproperty float nz\nproperty float wind_x\n"
                       "property float wind_y\nproperty float wind_z\nproperty float scalar_color\n",
                   "0 0 0 1 2 3 4 5 6 7 8 9 10\n"))
          .points;
  std::vector<std::string> names;
  for (const Attribute& attribute : points.attributes()) names.push_back(attribute.name);
  EXPECT_THAT(names, ElementsAre("heat", "scalar_label", "label", "normal", "wind", "scalar_color"));
  EXPECT_EQ(points.find("heat")->file.name, "scalar_heat");
  EXPECT_EQ(points.values<Eigen::Vector3f>("normal")[0], Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(points.values<Eigen::Vector3f>("wind")[0], Eigen::Vector3f(7, 8, 9));
  EXPECT_EQ(points.values<float>("scalar_label")[0], 2);
  EXPECT_EQ(points.values<std::int32_t>("label")[0], 3);
}

TEST(PlyReader, RowsThatAreNotFiniteGoWithTheirTriangles) {
  const auto result = readFromText(
      "a.ply", asciiPly("element vertex 5\n" + std::string(kXyz) +
                            "property float v\nelement face 2\nproperty list uchar int vertex_index\n",
                        "0 0 0 0\nnan 0 0 1\n1 0 0 nan\n0 1 0 3\n0 -inf 0 4\n3 0 2 3\n4 0 1 2 3\n"));
  EXPECT_EQ(result.dropped, 2u);
  EXPECT_EQ(result.points.size(), 3u);
  EXPECT_TRUE(std::isnan(result.points.values<float>("v")[1]));
  EXPECT_EQ(result.points.values<float>("v")[2], 3);
  EXPECT_THAT(result.points.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 2}));
}

TEST(PlyReader, PolygonsAreFannedAndStripsUnrolled) {
  const std::string five = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n";
  const auto fan =
      readFromText("a.ply", asciiPly("element vertex 5\n" + std::string(kXyz) +
                                         "element face 1\nproperty list int uint vertex_indices\n",
                                     five + "5 0 1 2 3 4\n"));
  EXPECT_THAT(fan.points.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}));
  const auto strip =
      readFromText("a.ply", asciiPly("element vertex 5\n" + std::string(kXyz) +
                                         "element tristrips 1\nproperty list int int vertex_indices\n",
                                     five + "8 0 1 2 3 -1 2 3 4\n"));
  EXPECT_THAT(strip.points.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}, Triangle{2, 3, 4}));
}

TEST(PlyReader, FacesCutOffAfterCompleteVerticesAreAWarning) {
  const std::string header =
      "element vertex 3\n" + std::string(kXyz) + "element face 2\nproperty list uchar int vertex_indices\n";
  const std::string ascii = asciiPly(header, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1\n");
  const std::string binary = "ply\nformat binary_little_endian 1.0\n" + header + "end_header\n" +
                             bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + "\x03" +
                             bytesOf<std::int32_t>({0, 1, 2}) + "\x03" + bytesOf<std::int32_t>({0});
  for (const std::string& file : {ascii, binary}) {
    const auto result = readFromText("a.ply", file);
    EXPECT_EQ(result.points.size(), 3u);
    EXPECT_THAT(result.points.triangles(), ElementsAre(Triangle{0, 1, 2}));
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("'face': 2 rows expected, 1 found")));
  }
}

TEST(PlyReader, FacesWithoutAListOfPointsAreAWarning) {
  const std::string header = "element vertex 1\n" + std::string(kXyz) +
                             "element face 1\nproperty list uchar double vertex_indices\n";
  const auto result = readFromText("a.ply", asciiPly(header, "0 0 0\n3 0 0 0\n"));
  EXPECT_TRUE(result.points.triangles().empty());
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("faces have no list")));
}

TEST(PlyReader, TruncatedVerticesNameBothCounts) {
  const std::string header = "element vertex 3\n" + std::string(kXyz);
  EXPECT_EQ(errorOfText("a.ply", asciiPly(header, "0 0 0\n1 0 0\n1 1")),
            "a.ply: ends too early: 3 points expected, 2 found");
  EXPECT_EQ(errorOfText("a.ply", "ply\nformat binary_big_endian 1.0\n" + header + "end_header\n" +
                                     std::string(30, '\0')),
            "a.ply: ends too early: 3 points expected, 2 found");
}

TEST(PlyReader, AFileThatEndsWithItsHeaderHasNoPoints) {
  EXPECT_EQ(errorOfText("a.ply", asciiPly("element vertex 1\n" + std::string(kXyz), "")),
            "a.ply: ends too early: 1 points expected, 0 found");
}

TEST(PlyReader, InflatedCountsFailWithoutTheMemory) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    for (const char* list : {"", "property list uchar int l\n"}) {
      const std::string file = std::string("ply\nformat ") + format + " 1.0\nelement vertex 4000000000\n" +
                               kXyz + list + "end_header\n0 0 0 0\n";
      EXPECT_THAT(errorOfText("a.ply", file), HasSubstr("4000000000 points expected")) << format << list;
    }
  }
  EXPECT_THAT(errorOfText("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\n" + std::string(kXyz) +
                                       "end_header\n"),
              HasSubstr("promises 99999999999 points"));
}

TEST(PlyReader, BadHeadersNameTheLine) {
  EXPECT_EQ(errorOfText("a.ply", "ply\nformat ascii 1.0\nelement vertex many\nend_header\n"),
            "a.ply: line 3 of the PLY header: 'many' is no number of elements");
  EXPECT_THAT(errorOfText("a.ply", "ply\nformat utf 1.0\nend_header\n"), HasSubstr("'utf' is no encoding"));
  EXPECT_THAT(errorOfText("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n"),
              HasSubstr("'quad' is no type"));
  EXPECT_THAT(errorOfText("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n"),
              HasSubstr("without 'end_header'"));
  EXPECT_THAT(
      errorOfText("a.ply", asciiPly("element vertex 1\nproperty float x\nproperty float y\n", "1 2\n")),
      HasSubstr("no property 'z'"));
  EXPECT_THAT(errorOfText("a.ply", asciiPly("element face 0\n", "")), HasSubstr("no element 'vertex'"));
  EXPECT_THAT(errorOfText("a.ply", asciiPly("element vertex 0\n" + std::string(kXyz), "")),
              HasSubstr("0 points"));
  EXPECT_EQ(errorOfText("a.ply", asciiPly("element vertex 1\n" + std::string(kXyz), "1 two 3\n")),
            "a.ply: line 8: 'two' is not a number");
}

TEST(PlyReader, DoublesFarFromZeroGetAnOrigin) {
  const PointSet points =
      readFromText(
          "a.ply",
          asciiPly("element vertex 2\nproperty double x\nproperty double y\nproperty double z\n",
                   "665187.522077 5648349.895035 241.767693\n665180.366089 5648347.104624 241.992427\n"))
          .points;
  EXPECT_NE(points.origin(), Eigen::Vector3d::Zero());
  const Eigen::Vector3d first = points.origin() + points.positions()[0].cast<double>();
  EXPECT_NEAR(first.x(), 665187.522077, 1e-6);
  EXPECT_NEAR(first.y(), 5648349.895035, 1e-6);
  for (const double value : points.origin()) EXPECT_EQ(value, std::round(value * 16) / 16);
  EXPECT_EQ(points.positionFileType(), ScalarType::kFloat64);
}

TEST(PlyReader, TheThreeEncodingsOfOneShelfAreTheSamePoints) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet ascii = readFile("formats/platonic_shelf_ascii.ply").points;
  const PointSet little = readFile("formats/platonic_shelf.ply").points;
  const PointSet big = readFile("formats/platonic_shelf_big_endian.ply").points;
  EXPECT_EQ(ascii.size(), 50u);
  for (const PointSet* other : {&little, &big}) {
    EXPECT_TRUE(sameBits(ascii.positionColumn().values(), other->positionColumn().values()));
    EXPECT_EQ(ascii.origin(), other->origin());
    EXPECT_EQ(ascii.triangles(), other->triangles());
  }
  EXPECT_FALSE(ascii.triangles().empty());
}

TEST(PlyReader, TheAsciiBunnyIsTheBinaryBunny) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet ascii = readFile("smooth/bun_zipper_ascii.ply").points;
  const PointSet binary = readFile("smooth/bun_zipper_binary_le_points.ply").points;
  ASSERT_EQ(ascii.size(), 35947u);
  EXPECT_TRUE(sameBits(ascii.positionColumn().values(), binary.positionColumn().values()));
  EXPECT_EQ(ascii.triangles().size(), 69451u);
  EXPECT_TRUE(ascii.has("confidence"));
  EXPECT_TRUE(binary.triangles().empty());
}

// The layout of this file is known: three floats, three bytes, three floats, little endian.
TEST(PlyReader, EqualsAStructDecodedByHand) {
  STIPPLE_NEEDS_TEST_DATA();
  const std::string content = contentOf(testData("formats/ripple_cloudcompare_binary.ply"));
  const char* row = content.data() + content.find("end_header\n") + 11;
  const PointSet points = readFile("formats/ripple_cloudcompare_binary.ply").points;
  ASSERT_EQ(points.size(), 10201u);
  for (Index i = 0; i < points.size(); ++i, row += 27) {
    float numbers[3];
    std::memcpy(numbers, row, 12);
    ASSERT_EQ(points.positions()[i], Eigen::Vector3f(numbers[0], numbers[1], numbers[2]));
    const auto* rgb = reinterpret_cast<const unsigned char*>(row + 12);
    ASSERT_EQ(points.values<Rgba8>("color")[i], (Rgba8{rgb[0], rgb[1], rgb[2]}));
    std::memcpy(numbers, row + 15, 12);
    ASSERT_EQ(points.values<Eigen::Vector3f>("normal")[i],
              Eigen::Vector3f(numbers[0], numbers[1], numbers[2]));
  }
}

struct RealFile {
  const char* name;
  Index points;
  std::size_t triangles;
};

class RealPly : public testing::TestWithParam<RealFile> {};

TEST_P(RealPly, HasTheStatedCounts) {
  STIPPLE_NEEDS_TEST_DATA();
  const auto result = readFile(GetParam().name);
  EXPECT_EQ(result.points.size() + result.dropped, GetParam().points);
  EXPECT_EQ(result.points.triangles().size(), GetParam().triangles);
}

INSTANTIATE_TEST_SUITE_P(SharedData, RealPly,
                         testing::Values(RealFile{"smooth/bunny_tristrips.ply", 34834, 69451},
                                         RealFile{"smooth/bunny70k_meshlab.ply", 34834, 69451},
                                         RealFile{"smooth/igea_134k.ply", 134345, 268686},
                                         RealFile{"colour/ankylosaurus_mesh.ply", 34820, 69636},
                                         RealFile{"colour/Laurana50k.ply", 27861, 49954},
                                         RealFile{"colour/rgbd_frame_1.ply", 120111, 0},
                                         RealFile{"noisy/lato000_rangemap.ply", 44461, 86766},
                                         RealFile{"noisy/lato180_rangemap.ply", 44716, 84635},
                                         RealFile{"noisy/lidar_street_source.ply", 69792, 0},
                                         RealFile{"formats/screwdriver_big_endian.ply", 6789, 13574},
                                         RealFile{"formats/icosahedron_ascii.ply", 12, 20}),
                         [](const auto& run) {
                           std::string name = run.param.name;
                           std::ranges::replace_if(
                               name, [](unsigned char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

}  // namespace
}  // namespace stipple
