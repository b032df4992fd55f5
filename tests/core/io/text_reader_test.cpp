#include "core/io/text_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/core/io/read_from_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ReadResult readFile(const std::string& relative) {
  Progress progress;
  return readPoints(testData(relative), progress);
}

std::vector<std::string> namesOf(const PointSet& points) {
  std::vector<std::string> names;
  for (const Attribute& attribute : points.attributes()) names.push_back(attribute.name);
  return names;
}

TEST(TextReader, EverySeparatorAndEndOfLine) {
  for (const char* text :
       {"1 2 3\n4 5 6\n", "1\t2\t3\r\n4\t5\t6\r\n", "1,2,3\n4, 5 ,6", "1;2;3\r\n\n 4 ;5;6\n\n"}) {
    const auto result = readFromText("a.xyz", text);
    EXPECT_THAT(result.points.positions(), ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)))
        << text;
    EXPECT_EQ(result.points.positionFileType(), ScalarType::kFloat32);
  }
}

TEST(TextReader, CountAndHeaderLines) {
  const auto counted = readFromText("a.pts", "2\n1 2 3\n4 5 6\n");
  EXPECT_EQ(counted.points.size(), 2u);
  EXPECT_THAT(counted.warnings, IsEmpty());
  EXPECT_THAT(readFromText("a.pts", "3\n1 2 3\n").warnings,
              ElementsAre(HasSubstr("promises 3 points, 1 found")));
  const auto named =
      readFromText("a.csv", "X,Y,Z,Heat,R,G,B,\"normal_x\",normal_y,normal_z\n1,2,3,0.5,9,8,7,0,0,1\n");
  EXPECT_THAT(namesOf(named.points), ElementsAre("Heat", "color", "normal"));
  EXPECT_EQ(named.points.values<Rgba8>("color")[0], (Rgba8{9, 8, 7}));
  EXPECT_EQ(named.points.values<Eigen::Vector3f>("normal")[0], Eigen::Vector3f(0, 0, 1));
  const auto commented = readFromText("a.txt", "//Z Y X\n1 2 3\n");
  EXPECT_THAT(commented.points.positions(), ElementsAre(Eigen::Vector3f(3, 2, 1)));
}

TEST(TextReader, ColumnsAreUnderstoodByTheirValues) {
  EXPECT_THAT(namesOf(readFromText("a.xyz", "0 0 0 7.5\n").points), ElementsAre("scalar"));
  EXPECT_THAT(namesOf(readFromText("a.xyz", "0 0 0 0 1 0\n1 1 1 -0.6 0.8 0\n").points),
              ElementsAre("normal"));
  EXPECT_THAT(namesOf(readFromText("a.xyz", "0 0 0 200 100 0\n1 1 1 255 255 255\n").points),
              ElementsAre("color"));
  EXPECT_THAT(namesOf(readFromText("a.pts", "0 0 0 -1035 97 59 38\n").points),
              ElementsAre("intensity", "color"));
  EXPECT_THAT(namesOf(readFromText("a.txt", "0 0 0 9 9 9 0 0 1\n0 0 1 9 8 7 1 0 0\n").points),
              ElementsAre("color", "normal"));
  EXPECT_THAT(namesOf(readFromText("a.txt", "0 0 0 12 9 9 9 0 0 1\n1 0 0 200 9 8 7 1 0 0\n").points),
              ElementsAre("intensity", "color", "normal"));
  EXPECT_THAT(namesOf(readFromText("a.txt", "0 0 0 12.5 900\n").points), ElementsAre("column_4", "column_5"));
}

TEST(TextReader, LargeIntegersStayExact) {
  const PointSet points = readFromText("a.txt", "0 0 0 1234567890123\n").points;
  EXPECT_EQ(points.values<double>("scalar")[0], 1234567890123.0);
}

TEST(TextReader, BadLinesAreNamed) {
  EXPECT_EQ(errorOfText("a.xyz", "1 2 3\n4 x 6\n"), "a.xyz: line 2: 'x' is not a number");
  EXPECT_EQ(errorOfText("a.xyz", "1 2 3\n4 5\n"), "a.xyz: line 2 has 2 columns, expected 3");
  EXPECT_THAT(errorOfText("a.xyz", "hello\nworld\n"), HasSubstr("line 2: 'world' is not a number"));
  EXPECT_THAT(errorOfText("a.xyz", "# nothing\n"), HasSubstr("0 points"));
}

TEST(TextReader, RowsOfVeryManyNumbersAreRefused) {
  std::string line;
  for (int c = 0; c < 5000; ++c) line += "1 ";
  EXPECT_EQ(errorOfText("a.xyz", line + "\n"), "a.xyz: has 5000 numbers a point, at most 4096 are read");
}

TEST(TextReader, NotFiniteRowsAreDropped) {
  const auto result = readFromText("a.xyz", "1 2 3\nnan 0 0\n1.#QNAN 0 0\n1.#INF 0 0\n4 5 6\n");
  EXPECT_EQ(result.dropped, 3u);
  EXPECT_THAT(result.points.positions(), ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)));
  EXPECT_THAT(errorOfText("a.xyz", "nan nan nan\n"), HasSubstr("no point with finite coordinates"));
}

TEST(PtxReader, AppliesTheTransformationOfEachScan) {
  // A quarter turn about z that takes x to y, then a shift by (10, 20, 30); then a second scan left where it
  // is.
  const std::string turned = "1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n";
  const std::string plain = "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  const auto result = readFromText("a.ptx", turned + "1 2 3 0.5\n" + plain + "4 5 6 0.25\n0 0 0 0.5\n");
  EXPECT_THAT(result.points.positions(),
              ElementsAre(Eigen::Vector3f(8, 21, 33), Eigen::Vector3f(4, 5, 6), Eigen::Vector3f(0, 0, 0)));
  EXPECT_THAT(result.points.values<float>("intensity"), ElementsAre(0.5F, 0.25F, 0.5F));
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("1 points lie in the scanner")));
}

TEST(TextReader, RealFilesHaveTheStatedCountsAndAttributes) {
  STIPPLE_NEEDS_TEST_DATA();
  const struct {
    const char* name;
    Index points;
    std::vector<std::string> attributes;
  } kFiles[] = {{"smooth/kitten.xyz", 5210, {"normal"}},
                {"cad/cube_50k.pwn", 50000, {"normal"}},
                {"noisy/sphere_20k_noise_outliers.xyz", 21000, {}},
                {"formats/bunnyData_leica.pts", 30571, {}},
                {"formats/leica_xyzirgb.pts", 19, {"intensity", "color"}},
                {"formats/ripple_nocount.pts", 10201, {"intensity", "color"}},
                {"formats/ripple.ptx", 10201, {"intensity", "color"}},
                {"formats/oni.pwn", 1435, {"normal"}},
                {"formats/points_agisoft.xyz", 100, {"color"}},
                {"formats/chameleon4k_surfels.pts", 4594, {"radius", "normal", "color"}}};
  for (const auto& file : kFiles) {
    const PointSet points = readFile(file.name).points;
    EXPECT_EQ(points.size(), file.points) << file.name;
    EXPECT_EQ(namesOf(points), file.attributes) << file.name;
  }
}

TEST(TextReader, MapCoordinatesKeepTheirDigits) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet points = readFile("formats/points_agisoft.xyz").points;
  EXPECT_EQ(points.positionFileType(), ScalarType::kFloat64);
  const Eigen::Vector3d first = points.origin() + points.positions()[0].cast<double>();
  EXPECT_LT((first - Eigen::Vector3d(665187.522077, 5648349.895035, 241.767693)).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_EQ(points.values<Rgba8>("color")[0], (Rgba8{117, 73, 49}));
}

TEST(TextReader, OneRippleInThreeFormatsIsTheSame) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet pts = readFile("formats/ripple_nocount.pts").points,
                 ptx = readFile("formats/ripple.ptx").points;
  EXPECT_TRUE(sameBits(pts.positionColumn().values(), ptx.positionColumn().values()));
  EXPECT_TRUE(sameBits(pts.find("color")->column.values(), ptx.find("color")->column.values()));
}

TEST(SurfelReader, EqualsAStructDecodedByHand) {
  STIPPLE_NEEDS_TEST_DATA();
  const std::string content = contentOf(testData("formats/chameleon4k_surfels.pts"));
  const PointSet points = readFile("formats/chameleon4k_surfels.pts").points;
  const char* record = content.data() + content.find("data\n") + 5;
  for (Index row = 0; row < points.size(); ++row, record += 32) {
    float numbers[7];
    std::memcpy(numbers, record, sizeof numbers);
    ASSERT_EQ(points.positions()[row], Eigen::Vector3f(numbers[0], numbers[1], numbers[2]));
    ASSERT_EQ(points.values<float>("radius")[row], numbers[3]);
    ASSERT_EQ(points.values<Eigen::Vector3f>("normal")[row],
              Eigen::Vector3f(numbers[4], numbers[5], numbers[6]));
    const auto* rgb = reinterpret_cast<const unsigned char*>(record + 28);
    ASSERT_EQ(points.values<Rgba8>("color")[row], (Rgba8{rgb[0], rgb[1], rgb[2], 255}));
  }
}

TEST(SurfelReader, TruncatedRecordsNameBothCounts) {
  const std::string header = "[Expe/PointSet/Binary/0.1]\nproperty position 12\nnofpoints 3\ndata\n";
  EXPECT_EQ(errorOfText("a.pts", header + std::string(25, '\0')),
            "a.pts: ends too early: 3 points expected, 2 found");
}

}  // namespace
}  // namespace stipple
