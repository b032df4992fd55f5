#include <nlohmann/json.hpp>

#include "tests/app/cli/cli_fixture.h"

namespace stipple {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST_F(Cli, InfoTellsWhatAFileHolds) {
  const json info = runJson({"info", writeExample(), "--json"});
  EXPECT_EQ(info["points"], 5);
  EXPECT_EQ(info["dropped"], 0);
  EXPECT_EQ(info["duplicates"], 1);
  EXPECT_EQ(info["triangles"], 0);
  EXPECT_EQ(info["bounds"], (json{{"min", {0, 0, -1}}, {"max", {7, 2, 0}}}));
  // Nearest distances of the 4 distinct points: 1, 1, 2, sqrt(21); either middle one is a median.
  EXPECT_GE(info["spacing"], 1);
  EXPECT_LE(info["spacing"], 2);
  const json expected = {{{"name", "mask"}, {"type", "float"}, {"min", 0}, {"max", 1}},
                         {{"name", "label"}, {"type", "int"}, {"min", -2}, {"max", 5}},
                         {{"name", "color"}, {"type", "color"}, {"min", {10, 0, 0}}, {"max", {50, 0, 255}}}};
  EXPECT_EQ(info["attributes"], expected);
  EXPECT_EQ(info["warnings"], json::array());
}

TEST_F(Cli, InfoCountsWhatWasDroppedAndHasNoSpacingBelowTwoPlaces) {
  const std::string file =
      write("two.xyz.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
            "property double z\nend_header\n500000.25 4 5\nnan 0 0\n500000.25 4 5\n");
  const json info = runJson({"info", file, "--json"});
  EXPECT_EQ(info["points"], 2);
  EXPECT_EQ(info["dropped"], 1);
  EXPECT_EQ(info["duplicates"], 1);
  EXPECT_TRUE(info["spacing"].is_null());
  EXPECT_EQ(info["bounds"]["min"], json({500000.25, 4, 5}));
}

TEST_F(Cli, InfoWritesNumbersThatAreNotFiniteAsNull) {
  const std::string file =
      write("odd.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nproperty float heat\nend_header\n0 0 0 nan\n");
  const json info = runJson({"info", file, "--json"});
  EXPECT_TRUE(info["attributes"][0]["min"].is_null());
  EXPECT_TRUE(info["attributes"][0]["max"].is_null());
}

TEST_F(Cli, InfoOfARealScan) {
  STIPPLE_NEEDS_TEST_DATA();
  const json info = runJson({"info", testData("colour/Laurana50k.ply").string(), "--json"});
  EXPECT_EQ(info["points"], 27861);     // "element vertex" of its header
  EXPECT_EQ(info["triangles"], 49954);  // "element face"
  EXPECT_EQ(info["attributes"][0]["name"], "color");
}

TEST_F(Cli, InfoWarnsOnStderrOrInsideTheDocument) {
  const std::string file =
      write("list.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nproperty list uchar int friends\nend_header\n0 0 0 2 1 2\n");
  const json info = runJson({"info", file, "--json"});
  ASSERT_EQ(info["warnings"].size(), 1u);
  EXPECT_THAT(info["warnings"][0].get<std::string>(), HasSubstr("friends"));
  const ProgramRun plain = run({"info", file});
  EXPECT_EQ(plain.exitCode, 0);
  EXPECT_THAT(plain.out, HasSubstr("points"));
  EXPECT_THAT(plain.err, HasSubstr("friends"));
}

}  // namespace
}  // namespace stipple
