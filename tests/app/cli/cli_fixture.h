#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/io/point_io.h"
#include "tests/support/program_run.h"
#include "tests/support/test_data.h"

namespace stipple {

/// Runs stipple-cli with the test operators as plugins, in a folder of its own that goes with the test.
class Cli : public testing::Test {
 protected:
  Cli();
  ~Cli() override;

  ProgramRun run(const std::vector<std::string>& arguments, int interruptAfterMs = 0) const;
  /// The document on stdout of a command that must succeed and keep stderr empty.
  nlohmann::json runJson(const std::vector<std::string>& arguments) const;
  /// The line on stderr of a command that must fail with `exitCode`, printing nothing else.
  std::string failWith(int exitCode, const std::vector<std::string>& arguments) const;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const;
  /// A PLY file of 5 points, the last equal to the first, with mask (float), label (int) and color.
  std::string writeExample() const;
  PointSet read(const std::string& name) const;
  /// Names of the files in the folder, sorted.
  std::vector<std::string> files() const;

  std::filesystem::path folder_;
};

}  // namespace stipple
