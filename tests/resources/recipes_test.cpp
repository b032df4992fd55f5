// Every recipe that is delivered does something to a scan, through the program as users call it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/io/point_io.h"
#include "tests/support/identical.h"
#include "tests/support/program_run.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

const std::filesystem::path kResources = STIPPLE_RESOURCES;

ProgramRun play(const std::filesystem::path& recipe, const std::filesystem::path& from,
                const std::filesystem::path& to) {
  return runProgram(STIPPLE_CLI, {"play", recipe.string(), from.string(), "-o", to.string()});
}

PointSet read(const std::filesystem::path& path) {
  Progress progress;
  return readPoints(path, progress).points;
}

TEST(Recipes, AllDoSomethingToTheSample) {
  const TemporaryFolder folder;
  // A quarter of the sample is enough to see whether they work.
  const std::filesystem::path thin = folder.path() / "thin.ply", out = folder.path() / "out.ply";
  const ProgramRun thinned = play(kResources / "recipes/thin_out.json", kResources / "sample/spot.ply", thin);
  ASSERT_EQ(thinned.exitCode, 0) << thinned.err;
  const PointSet before = read(thin);
  EXPECT_LT(before.size(), 40'000u);
  int played = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kResources / "recipes")) {
    if (entry.path().filename() == "prepare_scan.json") continue;  // may find nothing to remove, see below
    const ProgramRun run = play(entry.path(), thin, out);
    ASSERT_EQ(run.exitCode, 0) << entry.path() << ": " << run.err;
    EXPECT_FALSE(identical(before, read(out))) << entry.path();
    ++played;
  }
  EXPECT_GE(played, 11);
}

// The sample is painted over where its left eye is: dark before, as the skin around after.
TEST(Recipes, TheSampleLosesAnEye) {
  const TemporaryFolder folder;
  const std::filesystem::path sample = kResources / "sample/spot.ply", out = folder.path() / "out.ply";
  const ProgramRun run = play(kResources / "recipes/inpaint_sample.json", sample, out);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const PointSet before = read(sample), after = read(out);
  const auto dark = [](const Rgba8& c) { return c.r < 60; };
  const Eigen::Vector3f left(-0.1126f, -0.5098f, 0.6188f), right(0.0917f, -0.512f, 0.6188f);
  int leftBefore = 0, leftAfter = 0, rightAfter = 0;
  for (Index row = 0; row < before.size(); ++row) {
    const Eigen::Vector3f& p = before.positions()[row];
    const Rgba8 then = before.values<Rgba8>("color")[row], now = after.values<Rgba8>("color")[row];
    leftBefore += (p - left).norm() < 0.1f && dark(then);
    leftAfter += (p - left).norm() < 0.1f && dark(now);
    rightAfter += (p - right).norm() < 0.08f && dark(now);
  }
  EXPECT_GT(leftBefore, 100);
  EXPECT_EQ(leftAfter, 0);
  EXPECT_GT(rightAfter, 100);
}

TEST(Recipes, APreparedScanHasNormals) {
  const TemporaryFolder folder;
  const std::filesystem::path bare = folder.path() / "bare.ply", out = folder.path() / "out.ply";
  const PointSet sample = read(kResources / "sample/spot.ply");
  Progress progress;
  writePoints(bare, PointSet({sample.positions().begin(), sample.positions().end()}), {}, progress);
  const ProgramRun run = play(kResources / "recipes/prepare_scan.json", bare, out);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const PointSet prepared = read(out);
  ASSERT_EQ(prepared.size(), sample.size());
  const auto normals = prepared.values<Eigen::Vector3f>("normal"),
             given = sample.values<Eigen::Vector3f>("normal");
  Index agree = 0;
  for (Index row = 0; row < sample.size(); ++row) agree += normals[row].dot(given[row]) > 0.9f;
  EXPECT_GT(agree, 0.97 * sample.size());
}

}  // namespace
}  // namespace stipple
