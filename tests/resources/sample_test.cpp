#include <gtest/gtest.h>

#include <filesystem>

#include "core/io/point_io.h"

namespace stipple {
namespace {

const std::filesystem::path kSample = std::filesystem::path(STIPPLE_RESOURCES) / "sample";

TEST(Sample, IsAColoredPointSetWithUnitNormals) {
  Progress progress;
  const ReadResult result = readPoints(kSample / "spot.ply", progress);
  EXPECT_GE(result.points.size(), 50000u);
  EXPECT_EQ(result.dropped, 0u);
  EXPECT_EQ(result.points.values<Rgba8>("color").size(), result.points.size());
  for (const Eigen::Vector3f& normal : result.points.values<Eigen::Vector3f>("normal")) {
    ASSERT_NEAR(normal.norm(), 1, 1e-5);
  }
  EXPECT_LT(std::filesystem::file_size(kSample / "spot.ply"), 3'000'000u);
}

TEST(Sample, KeepsItsLicenseNote) {
  EXPECT_TRUE(std::filesystem::exists(kSample / "LICENSE_SPOT.txt"));
}

}  // namespace
}  // namespace stipple
