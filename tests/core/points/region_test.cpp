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

TEST(Region, OfAllHasEveryRow) {
  const PointSet points = fivePoints();
  const Region region = Region::all(points);
  EXPECT_TRUE(region.isAll());
  EXPECT_EQ(region.count(), 5u);
  EXPECT_TRUE(region.contains(4));
  EXPECT_FALSE(region.contains(5));
  EXPECT_THAT(region.rows(), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(region.mask(), ElementsAre(1, 1, 1, 1, 1));
}

TEST(Region, FromRowsSortsAndCountsRepeatedOnesOnce) {
  const Region region = Region::fromRows(fivePoints(), {3, 1, 3});
  EXPECT_FALSE(region.isAll());
  EXPECT_EQ(region.count(), 2u);
  EXPECT_TRUE(region.contains(1));
  EXPECT_FALSE(region.contains(2));
  EXPECT_THAT(region.rows(), ElementsAre(1, 3));
  EXPECT_THAT(region.mask(), ElementsAre(0, 1, 0, 1, 0));
}

TEST(Region, MayBeEmptyOrNameEveryRow) {
  const PointSet points = fivePoints();
  EXPECT_EQ(Region::fromRows(points, {}).count(), 0u);
  EXPECT_FALSE(Region::fromRows(points, {}).isAll());
  EXPECT_TRUE(Region::fromRows(points, {4, 3, 2, 1, 0}).isAll());
  EXPECT_TRUE(Region::all(PointSet()).isAll());
  EXPECT_THAT(Region::all(PointSet()).rows(), IsEmpty());
}

TEST(Region, RefusesARowThatThereIsNot) {
  try {
    Region::fromRows(fivePoints(), {2, 5});
    FAIL() << "row 5 of 5 was taken";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "row 5 of the region is not below 5");
  }
}

TEST(Region, FromAttributeTakesWhatIsNotZero) {
  PointSet points = fivePoints();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  points.set("f", std::vector<float>{0, -0.f, 1e-40f, kNan, -2});
  points.set("d", std::vector<double>{0, 1e-320, 0, 0, 0});
  points.set("i", std::vector<std::int32_t>{-1, 0, 0, 0, 2});
  points.set("u", std::vector<std::uint32_t>{0, 0, 4000000000u, 0, 0});
  points.set("v", std::vector<Eigen::Vector3f>{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}, {-1, 0, 0}, {0, 0, 0}});
  points.set("c",
             std::vector<Rgba8>{{0, 0, 0, 255}, {0, 0, 0, 0}, {0, 1, 0, 255}, {0, 0, 0, 7}, {0, 0, 9, 0}});
  EXPECT_THAT(Region::fromAttribute(points, "f").rows(), ElementsAre(2, 3, 4));
  EXPECT_THAT(Region::fromAttribute(points, "d").rows(), ElementsAre(1));
  EXPECT_THAT(Region::fromAttribute(points, "i").rows(), ElementsAre(0, 4));
  EXPECT_THAT(Region::fromAttribute(points, "u").rows(), ElementsAre(2));
  EXPECT_THAT(Region::fromAttribute(points, "v").rows(), ElementsAre(1, 3));
  EXPECT_THAT(Region::fromAttribute(points, "c").rows(), ElementsAre(2, 4));
  EXPECT_THROW(Region::fromAttribute(points, "g"), InvalidInput);
}

TEST(Region, FitsUntilRowsComeOrGo) {
  PointSet points = fivePoints();
  const Region region = Region::fromRows(points, {1});
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
