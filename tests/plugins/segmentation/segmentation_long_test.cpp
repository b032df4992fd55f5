#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numbers>

#include "core/io/point_io.h"
#include "tests/plugins/segmentation/segment_points.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double shareAcross(double turn, double setting, std::uint64_t seed, double noise) {
  const shapes::FacedPoints fold = shapes::foldedSquare(turn * std::numbers::pi / 180, 4900, seed, noise);
  PointSet points(fold.positions);
  points.set("seeds", seedInFirstFace(fold, 1));
  return shareOfFace(segmentsOf(points, {{"seeds", std::string("seeds")}, {"crease_angle", setting}}),
                     fold.faces, 1, 1);
}

// Noise in hundredths of the spacing.
class AtNoise : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(SegmentationLong, AtNoise, testing::Values(0, 10, 20),
                         testing::PrintToStringParamName());

TEST_P(AtNoise, StraightCreasesOnTwentySamples) {
  for (const double setting : {45.0, 60.0, 90.0}) {
    double leaked = 0, crossed = 1;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      leaked = std::max(leaked, shareAcross(setting + 10, setting, seed, 0.01 * GetParam()));
      crossed = std::min(crossed, shareAcross(setting - 20, setting, seed, 0.01 * GetParam()));
    }
    std::printf(
        "noise .%02d h, setting %g: of the other side at +10 degrees at most %.4f, at -20 at least %.4f\n",
        GetParam(), setting, leaked, crossed);
    EXPECT_LT(leaked, 0.03);
    EXPECT_GT(crossed, 0.97);
  }
}

TEST(SegmentationLong, FandiskAtOtherDensitiesAndWithNoise) {
  STIPPLE_NEEDS_TEST_DATA();
  Progress progress;
  const PointSet mesh = readPoints(testData("cad/fandisk.off"), progress).points;
  for (const auto& [count, noise] :
       {std::pair(30000, 0.0), {21000, 0.0}, {21000, 0.05}, {60000, 0.0}, {60000, 0.1}}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const shapes::FacedPoints samples =
          shapes::sampleFaces(mesh, 40 * std::numbers::pi / 180, count, seed, noise);
      const Score found = score(segmentsOf(PointSet(samples.positions), {{"fill", true}}), samples.faces);
      std::printf("%d points, noise %.2f h: %d segments, %d faces, purity %.4f, right %.4f\n", count, noise,
                  found.segments, found.facesFound, found.purity, found.right);
      EXPECT_EQ(found.facesFound, 12);
      EXPECT_GE(found.purity, 0.99);
      EXPECT_GE(found.right, 0.97);
    }
  }
}

TEST(SegmentationLong, ACubeOfAMillionPoints) {
  const shapes::FacedPoints cube = shapes::randomCube(1000000, 1);
  const double start = seconds();
  const Score found = score(segmentsOf(PointSet(cube.positions), {}), cube.faces);
  std::printf("%d segments, purity %.5f, labelled %.5f, %.1f s\n", found.segments, found.purity,
              found.labelled, seconds() - start);
  EXPECT_EQ(found.segments, 6);
  EXPECT_EQ(found.facesFound, 6);
  EXPECT_GT(found.purity, 0.999);
}

}  // namespace
}  // namespace stipple
