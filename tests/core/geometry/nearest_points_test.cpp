#include "core/geometry/nearest_points.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

TEST(NearestPoints, AreThoseOfASearchThroughAll) {
  const std::vector<Eigen::Vector3f> positions = shapes::randomSphere(700, 3),
                                     queries = shapes::randomSphere(1500, 4);
  const std::vector<Index> nearest = findNearestPoints(positions, queries);
  for (std::size_t q = 0; q < queries.size(); ++q) {
    for (const Eigen::Vector3f& p : positions) {
      EXPECT_LE((positions[nearest[q]] - queries[q]).squaredNorm(),
                (p - queries[q]).squaredNorm() * (1 + 1e-5f));
    }
  }
}

TEST(NearestPoints, OfEquallyNearOnesTheLowestRow) {
  const std::vector<Eigen::Vector3f> positions{{5, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0}};
  const std::vector<Eigen::Vector3f> queries{{0, 0, 0}, {-2, 0, 0}};
  EXPECT_EQ(findNearestPoints(positions, queries), (std::vector<Index>{1, 2}));
}

TEST(NearestPoints, RefusesAnEmptySet) {
  const std::vector<Eigen::Vector3f> queries{{0, 0, 0}};
  EXPECT_THROW(findNearestPoints({}, queries), InvalidInput);
}

}  // namespace
}  // namespace stipple
