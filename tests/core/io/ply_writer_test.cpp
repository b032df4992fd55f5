#include "core/io/ply_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ReadResult read(const std::filesystem::path& path) {
  Progress progress;
  return readPoints(path, progress);
}

std::vector<std::string> write(const std::filesystem::path& path, const PointSet& points, Encoding encoding) {
  Progress progress;
  return writePoints(path, points, {.encoding = encoding}, progress);
}

void expectSame(const PointSet& a, const PointSet& b) {
  EXPECT_TRUE(sameBits(a.positionColumn().values(), b.positionColumn().values()));
  EXPECT_EQ(a.origin(), b.origin());
  EXPECT_EQ(a.positionFileType(), b.positionFileType());
  EXPECT_EQ(a.triangles(), b.triangles());
  ASSERT_EQ(a.attributes().size(), b.attributes().size());
  for (std::size_t i = 0; i < a.attributes().size(); ++i) {
    const Attribute &left = a.attributes()[i], &right = b.attributes()[i];
    EXPECT_EQ(left.name, right.name);
    EXPECT_EQ(left.file.type, right.file.type);
    EXPECT_EQ(left.file.hasAlpha, right.file.hasAlpha);
    EXPECT_TRUE(sameBits(left.column.values(), right.column.values())) << left.name;
  }
}

class RoundTrip : public testing::TestWithParam<Encoding> {};

TEST_P(RoundTrip, KeepsEveryBitOfRealFiles) {
  STIPPLE_NEEDS_TEST_DATA();
  const TemporaryFolder folder;
  for (const char* name :
       {"colour/ankylosaurus_mesh.ply", "colour/Laurana50k.ply", "noisy/lato000_rangemap.ply",
        "noisy/lidar_street_source.ply", "formats/platonic_shelf_big_endian.ply"}) {
    SCOPED_TRACE(name);
    const PointSet points = read(testData(name)).points;
    EXPECT_THAT(write(folder / "out.ply", points, GetParam()), IsEmpty());
    expectSame(points, read(folder / "out.ply").points);
  }
}

TEST_P(RoundTrip, KeepsTheValuesOfEveryType) {
  const TemporaryFolder folder;
  const float tiny = std::numeric_limits<float>::denorm_min();
  PointSet points({{tiny, -0.0F, 3.4028235e38F}, {0.1F, 1.0F / 3, -16777216}});
  points.set("f", std::vector<float>{std::numeric_limits<float>::infinity(), 1.17549435e-38F});
  points.set("d", std::vector<double>{0.1, 4.9e-324});
  points.set("i", std::vector<std::int32_t>{-2147483647 - 1, 2147483647});
  points.set("u", std::vector<std::uint32_t>{0, 4294967295u});
  points.set("v", std::vector<Eigen::Vector3f>{{1, 2, 3}, {0.1F, 0.2F, 0.3F}});
  points.set("normal", std::vector<Eigen::Vector3f>{{0, 0, 1}, {0.6F, 0.8F, 0}});
  points.set("color", std::vector<Rgba8>{{1, 2, 3, 4}, {255, 254, 253, 252}}, {"", ScalarType::kUint8, true});
  points.setTriangles({{0, 1, 1}});
  EXPECT_THAT(write(folder / "out.ply", points, GetParam()), IsEmpty());
  expectSame(points, read(folder / "out.ply").points);
}

INSTANTIATE_TEST_SUITE_P(Encodings, RoundTrip, testing::Values(Encoding::kBinary, Encoding::kAscii),
                         [](const auto& entry) {
                           return entry.param == Encoding::kBinary ? "binary" : "ascii";
                         });

TEST(PlyWriter, NotANumberIsKeptBitForBit) {
  const TemporaryFolder folder;
  PointSet points({{0, 0, 0}});
  points.set("v", std::vector<float>{std::bit_cast<float>(0xffc12345u)});
  write(folder / "out.ply", points, Encoding::kBinary);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(read(folder / "out.ply").points.values<float>("v")[0]), 0xffc12345u);
}

TEST(PlyWriter, BinaryPointsOfFloatsComeBackByteForByte) {
  STIPPLE_NEEDS_TEST_DATA();
  const TemporaryFolder folder;
  const auto source = testData("smooth/bun_zipper_binary_le_points.ply");
  write(folder / "out.ply", read(source).points, Encoding::kBinary);
  const auto data = [](const std::string& content) { return content.substr(content.find("end_header\n")); };
  EXPECT_EQ(data(contentOf(folder / "out.ply")), data(contentOf(source)));
}

TEST(PlyWriter, AttributesOfOurOwnAreScalars) {
  const TemporaryFolder folder;
  PointSet points({{0, 0, 0}});
  points.set("heat", std::vector<float>{1});
  points.set("my label", std::vector<std::int32_t>{7});
  points.set("kept", std::vector<std::uint32_t>{9}, {"kept", ScalarType::kUint16});
  write(folder / "out.ply", points, Encoding::kAscii);
  EXPECT_EQ(
      contentOf(folder / "out.ply"),
      "ply\nformat ascii 1.0\ncomment written by Stipple\nelement vertex 1\nproperty float x\nproperty float "
      "y\n"
      "property float z\nproperty float scalar_heat\nproperty int scalar_my_label\nproperty ushort kept\n"
      "end_header\n0 0 0 1 7 9\n");
}

TEST(PlyWriter, ValuesBeyondTheTypeOfTheFileWidenIt) {
  const TemporaryFolder folder;
  PointSet points({{0, 0, 0}});
  points.set("label", std::vector<std::uint32_t>{300}, {"label", ScalarType::kUint8});
  EXPECT_THAT(write(folder / "out.ply", points, Encoding::kBinary),
              ElementsAre(HasSubstr("beyond the uchar")));
  EXPECT_EQ(read(folder / "out.ply").points.values<std::uint32_t>("label")[0], 300u);
}

TEST(PlyWriter, DoublesComeBackAsDoubles) {
  const TemporaryFolder folder;
  setContent(
      folder / "in.ply",
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
      "end_header\n665187.5 5648349.25 241.75\n665180.125 5648347.5 241.5\n");
  write(folder / "out.ply", read(folder / "in.ply").points, Encoding::kAscii);
  EXPECT_THAT(contentOf(folder / "out.ply"), HasSubstr("property double x\n"));
  // These coordinates are multiples of 1/8: exact relative to any origin that is a multiple of a power of
  // two.
  EXPECT_THAT(contentOf(folder / "out.ply"),
              HasSubstr("665187.5 5648349.25 241.75\n665180.125 5648347.5 241.5\n"));
}

}  // namespace
}  // namespace stipple
