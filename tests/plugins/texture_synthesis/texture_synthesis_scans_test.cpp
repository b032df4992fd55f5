#include <gtest/gtest.h>

#include <cmath>

#include "tests/plugins/texture_synthesis/grown_patterns.h"
#include "tests/plugins/texture_synthesis/scanned_patterns.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

TEST(TextureSynthesisOnScans, SpotsStandAtTheWantedDistanceOnTheBunny) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet bunny = readScan("smooth/bun_zipper_ascii.ply");
  const double area = meshArea(bunny);
  for (const double size : {0.015, 0.022})
    EXPECT_NEAR(relativeSpotDistance(bunny, size, area), 1, 0.1) << size;
}

TEST(TextureSynthesisOnScans, SpotsStandAtTheWantedDistanceOnTheHead) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet head = readScan("smooth/igea_134k.ply");
  const double area = meshArea(head), size = std::sqrt(area / 150);
  EXPECT_NEAR(relativeSpotDistance(thinned(head, 6), size, area), 1, 0.1);
}

TEST(TextureSynthesisOnScans, EveryPatternFormsOnScansWithoutTuning) {
  STIPPLE_NEEDS_TEST_DATA();
  for (const char* path : {"smooth/kitten.xyz", "cad/fandisk.off", "open/mountain_25k.obj"}) {
    const PointSet scan = readScan(path);
    for (const char* pattern : {"spots", "stripes", "zebra", "gierer_meinhardt"}) {
      const PointSet grown =
          growPattern(scan, {{"pattern", std::string(pattern)}, {"steps", std::int64_t{150}}});
      for (const float value : grown.values<float>("species_a")) ASSERT_TRUE(std::isfinite(value)) << path;
    }
  }
}

}  // namespace
}  // namespace stipple
