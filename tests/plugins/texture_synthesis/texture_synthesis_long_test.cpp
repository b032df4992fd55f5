#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/plugins/texture_synthesis/grown_patterns.h"
#include "tests/plugins/texture_synthesis/scanned_patterns.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

TEST(TextureSynthesisLong, SpotsOfTheHeadDoNotKnowItsDensity) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet dense = readScan("smooth/igea_134k.ply"), sparse = thinned(dense, 4);
  ASSERT_NEAR(sparse.size(), 33500, 1500);
  const double area = meshArea(dense), size = std::sqrt(area / 300);
  const double ofDense = relativeSpotDistance(dense, size, area),
               ofSparse = relativeSpotDistance(sparse, size, area);
  EXPECT_NEAR(ofDense, 1, 0.1);
  EXPECT_NEAR(ofSparse, 1, 0.1);
  EXPECT_NEAR(ofSparse / ofDense, 1, 0.1);
}

TEST(TextureSynthesisLong, SpotsOfASphereDoNotKnowItsDensity) {
  const double area = 4 * std::numbers::pi, size = 0.25;
  const double ofDense = relativeSpotDistance(PointSet(fibonacciSphere(134000)), size, area);
  const double ofSparse = relativeSpotDistance(PointSet(fibonacciSphere(35000)), size, area);
  EXPECT_NEAR(ofDense, 1, 0.1);
  EXPECT_NEAR(ofSparse / ofDense, 1, 0.1);
}

}  // namespace
}  // namespace stipple
