#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/point_io.h"
#include "tests/support/program_run.h"

namespace stipple {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kPrefix = EXTERNAL_PREFIX;
const fs::path kProgram = kPrefix / "bin/stipple-cli";

bool listsLift(const ProgramOptions& options) {
  const ProgramRun listing = runProgram(kProgram, {"operators", "--json"}, options);
  EXPECT_EQ(listing.exitCode, 0) << listing.err;
  const json document = json::parse(listing.out);
  EXPECT_EQ(document["warnings"], json::array());
  return std::ranges::any_of(document["operators"], [](const json& op) { return op["id"] == "lift"; });
}

// A flat grid of 20 x 20 points, a unit apart, the left half of it marked.
fs::path writeGrid() {
  const fs::path file = fs::path(EXTERNAL_BUILD) / "grid.ply";
  std::ofstream text(file);
  text << "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float y\nproperty float z\n"
          "property int left\nend_header\n";
  for (int i = 0; i < 400; ++i) text << i % 20 << ' ' << i / 20 << " 0 " << (i % 20 < 10) << '\n';
  return file;
}

TEST(ExternalPlugin, AppearsWithItsFileAndGoesWithIt) {
  const fs::path installed = kPrefix / EXTERNAL_PLUGIN_DIR / "lift.so";
  fs::remove(installed);
  EXPECT_FALSE(listsLift({}));
  fs::create_directories(installed.parent_path());
  fs::copy_file(fs::path(EXTERNAL_BUILD) / "lift.so", installed);
  EXPECT_TRUE(listsLift({}));
  fs::remove(installed);
  EXPECT_FALSE(listsLift({}));
}

TEST(ExternalPlugin, RunsInTheInstalledProgram) {
  const fs::path grid = writeGrid(), lifted = fs::path(EXTERNAL_BUILD) / "lifted.ply";
  const ProgramOptions options{.environment = {std::string("STIPPLE_PLUGIN_PATH=") + EXTERNAL_BUILD}};
  const ProgramRun done = runProgram(
      kProgram, {"run", "lift", grid, "-o", lifted, "--set", "by=0.5", "--region", "left", "--json"},
      options);
  ASSERT_EQ(done.exitCode, 0) << done.err;
  // Half of the area of the grid: 19 x 9.5 to the middle line between the columns 9 and 10.
  EXPECT_NEAR(json::parse(done.out)["report"]["area"].get<double>(), 19 * 9.5, 1e-3 * 19 * 9.5);
  Progress progress;
  const PointSet points = readPoints(lifted, progress).points;
  for (Index row = 0; row < points.size(); ++row) {
    EXPECT_EQ(points.positions()[row].z(), row % 20 < 10 ? 0.5f : 0.0f);
  }
}

}  // namespace
}  // namespace stipple
