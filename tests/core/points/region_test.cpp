#include "core/points/region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

PointSet fivePoints() {
  return PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
}

TEST(Region, IsEveryRowOfAnySetByDefault) {
  const Region region;
  EXPECT_TRUE(region.isEverything());
  EXPECT_EQ(region.count(3), 3u);
  EXPECT_TRUE(region.contains(7));
  EXPECT_THAT(region.rows(3), ElementsAre(0, 1, 2));
  EXPECT_THAT(region.mask(), IsEmpty());
  EXPECT_TRUE(region.fits(fivePoints()));
}

TEST(Region, OfRowsCountsRepeatedOnesOnce) {
  const Region region = regionOfRows(fivePoints(), std::vector<Index>{3, 1, 3});
  EXPECT_FALSE(region.isEverything());
  EXPECT_EQ(region.count(5), 2u);
  EXPECT_TRUE(region.contains(1));
  EXPECT_FALSE(region.contains(2));
  EXPECT_THAT(region.rows(5), ElementsAre(1, 3));
  EXPECT_THAT(region.mask(), ElementsAre(0, 1, 0, 1, 0));
  EXPECT_EQ(regionOfRows(fivePoints(), {}).count(5), 0u);
}

TEST(Region, RefusesAMaskOfAnotherLength) {
  EXPECT_THROW(Region(fivePoints(), {1, 0, 0}), InvalidInput);
}

TEST(Region, RefusesARowThatThereIsNot) {
  try {
    regionOfRows(fivePoints(), std::vector<Index>{2, 5});
    FAIL() << "row 5 of 5 was taken";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "row 5 of the region is not below 5");
  }
}

TEST(Region, TakesWhereAnAttributeOfAnyTypeIsNotZero) {
  PointSet points = fivePoints();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  points.set("f", std::vector<float>{0, -0.f, 1e-40f, kNan, -2});
  points.set("d", std::vector<double>{0, 1e-320, 0, 0, 0});
  points.set("i", std::vector<std::int32_t>{-1, 0, 0, 0, 2});
  points.set("u", std::vector<std::uint32_t>{0, 0, 4000000000u, 0, 0});
  points.set("v", std::vector<Eigen::Vector3f>{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}, {-1, 0, 0}, {0, 0, 0}});
  points.set("c",
             std::vector<Rgba8>{{0, 0, 0, 255}, {0, 0, 0, 0}, {0, 1, 0, 255}, {0, 0, 0, 7}, {0, 0, 9, 0}});
  EXPECT_THAT(regionWhereNotZero(points, "f").rows(5), ElementsAre(2, 3, 4));
  EXPECT_THAT(regionWhereNotZero(points, "d").rows(5), ElementsAre(1));
  EXPECT_THAT(regionWhereNotZero(points, "i").rows(5), ElementsAre(0, 4));
  EXPECT_THAT(regionWhereNotZero(points, "u").rows(5), ElementsAre(2));
  EXPECT_THAT(regionWhereNotZero(points, "v").rows(5), ElementsAre(1, 3));
  EXPECT_THAT(regionWhereNotZero(points, "c").rows(5), ElementsAre(2, 4));
  EXPECT_THROW(regionWhereNotZero(points, "g"), InvalidInput);
}

TEST(Region, FitsUntilRowsComeOrGo) {
  PointSet points = fivePoints();
  const Region region = regionOfRows(points, std::vector<Index>{1});
  points.set("f", std::vector<float>(5));
  points.editPositions()[0].x() = 7;
  EXPECT_TRUE(region.fits(points));
  EXPECT_TRUE(region.fits(PointSet(points)));
  points.removeRows(std::vector<Index>{0});
  EXPECT_FALSE(region.fits(points));
  EXPECT_FALSE(region.fits(fivePoints()));
}

}  // namespace
}  // namespace stipple
