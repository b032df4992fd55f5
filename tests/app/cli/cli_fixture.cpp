#include "tests/app/cli/cli_fixture.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace stipple {

namespace fs = std::filesystem;

Cli::Cli() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::temp_directory_path() / ("stipple_cli_" + std::to_string(getpid()) + "_" + test->name());
  fs::create_directories(folder_);
}

Cli::~Cli() {
  fs::remove_all(folder_);
}

ProgramRun Cli::run(const std::vector<std::string>& arguments, int interruptAfterMs) const {
  const std::string built = STIPPLE_BINARY_DIR;
  return runProgram(built + "/bin/stipple-cli", arguments,
                    {.environment = {"STIPPLE_PLUGIN_PATH=" + built + "/tests/plugins"},
                     .interruptAfterMs = interruptAfterMs});
}

nlohmann::json Cli::runJson(const std::vector<std::string>& arguments) const {
  const ProgramRun done = run(arguments);
  EXPECT_EQ(done.exitCode, 0);
  EXPECT_EQ(done.err, "");
  return nlohmann::json::parse(done.out);
}

std::string Cli::failWith(int exitCode, const std::vector<std::string>& arguments) const {
  const ProgramRun done = run(arguments);
  EXPECT_EQ(done.exitCode, exitCode) << done.err;
  EXPECT_EQ(done.out, "");
  EXPECT_EQ(countLines(done.err), 1) << done.err;
  EXPECT_TRUE(done.err.ends_with('\n'));
  return done.err;
}

std::string Cli::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return path(name);
}

std::string Cli::writeExample() const {
  return write(
      "example.ply",
      "ply\nformat ascii 1.0\nelement vertex 5\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float scalar_mask\nproperty int label\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
      "0 0 0 0 1 10 0 0\n1 0 0 0.5 -2 20 0 0\n3 0 0 0 3 30 0 255\n7 2 -1 nan 4 40 0 0\n0 0 0 1 5 50 0 0\n");
}

PointSet Cli::read(const std::string& name) const {
  Progress progress;
  return readPoints(folder_ / name, progress).points;
}

std::vector<std::string> Cli::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace stipple
