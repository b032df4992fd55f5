#include "core/points/region.h"

#include <gmock/gmock.h>

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

PointSet threePoints() {
  return PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
}

TEST(Region, IsEverythingByDefault) {
  const Region region;
  EXPECT_TRUE(region.isEverything());
  EXPECT_TRUE(region.contains(7));
  EXPECT_THAT(region.rows(3), ElementsAre(0, 1, 2));
  EXPECT_TRUE(region.fits(threePoints()));
}

TEST(Region, HoldsTheRowsWhereAnAttributeOfAnyTypeIsNotZero) {
  PointSet points = threePoints();
  points.set("a", std::vector<float>{0, -0.5f, 0});
  points.set("b", std::vector<std::int32_t>{3, 0, 0});
  points.set("c", std::vector<Eigen::Vector3f>{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}});
  points.set("d", std::vector<Rgba8>{{0, 0, 0, 255}, {1, 0, 0, 255}, {0, 0, 0, 255}});
  EXPECT_THAT(regionWhereNotZero(points, "a").rows(3), ElementsAre(1));
  EXPECT_THAT(regionWhereNotZero(points, "b").rows(3), ElementsAre(0));
  EXPECT_THAT(regionWhereNotZero(points, "c").rows(3), ElementsAre(2));
  EXPECT_THAT(regionWhereNotZero(points, "d").rows(3), ElementsAre(1));
  EXPECT_THAT([&] { regionWhereNotZero(points, "mask"); }, ThrowsMessage<InvalidInput>(HasSubstr("'mask'")));
}

TEST(Region, KnowsThatRowsMoved) {
  PointSet points = threePoints();
  const Region region(points, {1, 0, 0});
  EXPECT_TRUE(region.fits(points));
  points.removeRows(std::vector<Index>{0});
  EXPECT_FALSE(region.fits(points));
  EXPECT_THROW(Region(points, {1, 0, 0}), InvalidInput);
}

}  // namespace
}  // namespace stipple
