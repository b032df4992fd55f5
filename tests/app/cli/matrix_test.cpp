// Every operator at its defaults on every real scan: a result without NaN, or one clear sentence, and memory
// below 2 KB a point. A seventh of all pairs, another one for each scan; all of them where
// STIPPLE_WHOLE_MATRIX is set.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/io/point_io.h"
#include "tests/support/program_run.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

#ifdef STIPPLE_WHOLE_MATRIX
constexpr std::size_t kOneOf = 1;
#else
constexpr std::size_t kOneOf = 7;
#endif
// What the program and its libraries take by themselves.
constexpr std::size_t kOwnBytes = 60 << 20, kBytesOfPoint = 2048;
// Sanitizers take memory of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMeasuresMemory = false;
#else
constexpr bool kMeasuresMemory = true;
#endif

ProgramRun cli(const std::vector<std::string>& arguments) {
  return runProgram(STIPPLE_CLI, arguments);
}

std::vector<std::string> operators() {
  const nlohmann::json listed = nlohmann::json::parse(cli({"operators", "--json"}).out);
  std::vector<std::string> ids;
  for (const auto& op : listed["operators"]) ids.push_back(op["id"]);
  return ids;
}

std::vector<std::filesystem::path> scans() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(STIPPLE_TEST_DATA)) {
    if (entry.is_regular_file() && cli({"info", entry.path().string()}).exitCode == 0)
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::size_t countNan(const AttributeValues& values) {
  return std::visit(
      [](const auto& column) {
        std::size_t count = 0;
        for (const auto& value : column) {
          using T = std::decay_t<decltype(value)>;
          if constexpr (std::is_floating_point_v<T>) count += std::isnan(value);
          if constexpr (std::is_same_v<T, Eigen::Vector3f>) count += value.hasNaN();
        }
        return count;
      },
      values);
}

// NaN in attributes that were not there, or more than there was; positions are finite or the reader drops
// them.
void expectNoNewNan(const PointSet& before, const ReadResult& after) {
  EXPECT_EQ(after.dropped, 0u);
  for (const Attribute& attribute : after.points.attributes()) {
    const Attribute* given = before.find(attribute.name);
    EXPECT_LE(countNan(attribute.column.values()), given ? countNan(given->column.values()) : 0)
        << attribute.name;
  }
}

void expectResultOrSentence(const std::string& op, const std::filesystem::path& scan,
                            const TemporaryFolder& folder) {
  Progress progress;
  const PointSet before = readPoints(scan, progress).points;
  const std::string out = (folder.path() / "out.ply").string(),
                    marked = (folder.path() / "marked.ply").string();
  std::filesystem::remove(out);
  PointSet points = before;
  std::vector<float> mask(points.size());
  for (Index row = 0; row < points.size(); ++row) mask[row] = row % 10 == 0;
  points.set("every_tenth", mask);
  writePoints(marked, points, {}, progress);
  std::vector<std::string> arguments{"run", op, marked, "-o", out};
  if (op == "inpainting" || op == "delete_points")
    arguments.insert(arguments.end(), {"--region", "every_tenth"});
  if (op == "transfer_attributes") arguments.insert(arguments.end(), {"--set", "from=" + marked});
  const ProgramRun run = cli(arguments);
  if (run.exitCode == 0) {
    expectNoNewNan(before, readPoints(out, progress));
  } else {
    EXPECT_TRUE(run.exitCode == 1 || run.exitCode == 2) << run.exitCode;
    EXPECT_EQ(countLines(run.err), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
  if (kMeasuresMemory) {
    EXPECT_LT(run.peakBytes, kOwnBytes + kBytesOfPoint * before.size());
  }
}

TEST(Matrix, EveryOperatorOnEveryScanGivesAResultOrASentence) {
  STIPPLE_NEEDS_TEST_DATA();
  const std::vector<std::string> ids = operators();
  const auto files = scans();
  ASSERT_GE(ids.size(), 14u);
  ASSERT_GE(files.size(), 30u);
  const TemporaryFolder folder;
  for (std::size_t f = 0; f < files.size(); ++f) {
    for (std::size_t o = 0; o < ids.size(); ++o) {
      if ((f + o) % kOneOf != 0) continue;
      SCOPED_TRACE(ids[o] + " on " + files[f].string());
      expectResultOrSentence(ids[o], files[f], folder);
    }
  }
}

}  // namespace
}  // namespace stipple
