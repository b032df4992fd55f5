#include "core/io/off_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/io/read_from_text.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(OffReader, CommentsBlankLinesAndCarriageReturns) {
  for (const char* begin : {"OFF\n4 1 0\n", "OFF # shape\r\n# counts\r\n\r\n4 1 0\r\n", "OFF 4 1 0\n",
                            "4 1 6\n", "# c\nOFF\n4 1\n"}) {
    const auto result = readFromText(
        "a.off", std::string(begin) + "0 0 0\n1 0 0 # corner\r\n\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n");
    EXPECT_EQ(result.points.size(), 4u) << begin;
    EXPECT_THAT(result.points.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_THAT(result.warnings, IsEmpty());
  }
}

TEST(OffReader, ColorsAndNormals) {
  const auto bytes = readFromText("a.off", "COFF\n1 0 0\n1 2 3 9 8 7 128\n");
  EXPECT_EQ(bytes.points.values<Rgba8>("color")[0], (Rgba8{9, 8, 7, 128}));
  const auto real = readFromText("a.off", "COFF\n2 0 0\n1 2 3 0 0 1.0\n1 2 4 0.2 0 0\n");
  EXPECT_THAT(real.points.values<Rgba8>("color"), ElementsAre(Rgba8{0, 0, 255}, Rgba8{51, 0, 0}));
  const auto both = readFromText("a.off", "CNOFF\n1 0 0\n1 2 3 0 0 1 1 0 1\n");
  EXPECT_EQ(both.points.values<Eigen::Vector3f>("normal")[0], Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(both.points.values<Rgba8>("color")[0], (Rgba8{1, 0, 1}));
  EXPECT_TRUE(readFromText("a.off", "NOFF\n1 0 0\n1 2 3 0 0 1\n").points.has("normal"));
  EXPECT_TRUE(readFromText("a.off", "OFF\n1 0 0\n1 2 3 9 8 7\n").points.has("color"));
}

TEST(OffReader, ErrorsAndWarnings) {
  EXPECT_EQ(errorOfText("a.off", "OFF\n3 0 0\n0 0 0\n1 1 1\n"),
            "a.off: ends too early: 3 points expected, 2 found");
  EXPECT_EQ(errorOfText("a.off", "OFF\n4000000000 0 0\n0 0 0\n"),
            "a.off: ends too early: 4000000000 points expected, 1 found");
  EXPECT_THAT(errorOfText("a.off", "OFF\nmany\n"), HasSubstr("no counts"));
  EXPECT_THAT(errorOfText("a.off", "OFF\n0 0 0\n"), HasSubstr("0 points"));
  EXPECT_THAT(errorOfText("a.off", "4OFF\n1 0 0\n0 0 0 1\n"), HasSubstr("kind 4OFF"));
  EXPECT_THAT(errorOfText("a.off", "OFF BINARY\n"), HasSubstr("binary OFF"));
  EXPECT_EQ(errorOfText("a.off", "OFF\n2 0 0\n0 0 0\n0 o 0\n"), "a.off: line 4: 'o' is not a number");
  const auto result = readFromText("a.off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n3 0 1 2\n3 0 1\n");
  EXPECT_THAT(result.points.triangles(), ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(result.warnings,
              ElementsAre(HasSubstr("3 expected, 2 found"), HasSubstr("1 faces name points")));
}

TEST(OffReader, RealFilesHaveTheStatedCounts) {
  STIPPLE_NEEDS_TEST_DATA();
  const struct {
    const char* name;
    Index points;
    std::size_t triangles;
  } kFiles[] = {{"cad/fandisk.off", 7229, 14454},          {"cad/casting.off", 5096, 10224},
                {"cad/cube_noisy.off", 7526, 15048},       {"open/lion-head.off", 8356, 16674},
                {"open/camelhead_crlf.off", 11381, 22704}, {"open/hemisphere.off", 1861, 3600},
                {"smooth/bunny_adaptive.off", 5884, 11764}};
  for (const auto& file : kFiles) {
    Progress progress;
    const auto result = readPoints(testData(file.name), progress);
    EXPECT_EQ(result.points.size(), file.points) << file.name;
    EXPECT_EQ(result.points.triangles().size(), file.triangles) << file.name;
    EXPECT_THAT(result.warnings, IsEmpty()) << file.name;
  }
}

}  // namespace
}  // namespace stipple
