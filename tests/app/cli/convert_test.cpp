#include "tests/app/cli/cli_fixture.h"

namespace stipple {
namespace {

using testing::HasSubstr;

TEST_F(Cli, ConvertWritesTheSamePointsInEitherEncoding) {
  const std::string example = writeExample();
  for (const char* encoding : {"ascii", "binary"}) {
    const ProgramRun done = run({"convert", example, path("out.ply"), "--encoding", encoding});
    EXPECT_EQ(done.exitCode, 0);
    EXPECT_EQ(done.out + done.err, "");
    const PointSet points = read("out.ply"), original = read("example.ply");
    EXPECT_TRUE(sameBits(points.positionColumn().values(), original.positionColumn().values()));
    ASSERT_EQ(points.attributes().size(), 3u);
    for (const Attribute& attribute : original.attributes()) {
      EXPECT_TRUE(sameBits(points.find(attribute.name)->column.values(), attribute.column.values()));
    }
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"example.ply", "out.ply"}));
}

TEST_F(Cli, ConvertMayReplaceItsInput) {
  const std::string example = writeExample();
  EXPECT_EQ(run({"convert", example, example}).exitCode, 0);
  EXPECT_EQ(read("example.ply").size(), 5u);
}

TEST_F(Cli, AFailedConversionKeepsTheOldFile) {
  const std::string old = write("out.ply", "precious");
  failWith(3, {"convert", path("absent.ply"), old});
  EXPECT_EQ(std::filesystem::file_size(old), 8u);
}

}  // namespace
}  // namespace stipple
