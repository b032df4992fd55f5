#include "plugins/segmentation/seeds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

PointSet threePoints(AttributeValues seeds) {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  points.set("seeds", std::move(seeds));
  return points;
}

TEST(Seeds, AnyWholeNumbersWillDo) {
  EXPECT_THAT(readSeeds(threePoints(std::vector<std::int32_t>{0, -4, 2}), "seeds"), ElementsAre(0, -4, 2));
  EXPECT_THAT(readSeeds(threePoints(std::vector<float>{0, 3, 0}), "seeds"), ElementsAre(0, 3, 0));
  EXPECT_THAT(readSeeds(threePoints(std::vector<double>{7, 0, 0}), "seeds"), ElementsAre(7, 0, 0));
  EXPECT_THAT(readSeeds(threePoints(std::vector<std::uint32_t>{0, 0, 9}), "seeds"), ElementsAre(0, 0, 9));
}

TEST(Seeds, SaysWhatCannotBeUsed) {
  EXPECT_THAT(
      [] {
        readSeeds(threePoints(std::vector<float>{0, 0.5f, 0}), "seeds");
      },
      ThrowsMessage<InvalidInput>(HasSubstr("seeds[1] is 0.5")));
  EXPECT_THAT(
      [] {
        readSeeds(threePoints(std::vector<float>{0, 0, std::nanf("")}), "seeds");
      },
      ThrowsMessage<InvalidInput>(HasSubstr("seeds[2] is nan")));
  EXPECT_THAT(
      [] {
        readSeeds(threePoints(std::vector<std::uint32_t>{0, 4000000000u, 1}), "seeds");
      },
      ThrowsMessage<InvalidInput>(HasSubstr("seeds[1] is 4000000000")));
  EXPECT_THAT(
      [] {
        readSeeds(threePoints(std::vector<std::int32_t>{0, 0, 0}), "seeds");
      },
      ThrowsMessage<InvalidInput>(HasSubstr("holds no seed")));
  EXPECT_THAT([] { readSeeds(threePoints(std::vector<Rgba8>(3)), "seeds"); },
              ThrowsMessage<InvalidInput>(HasSubstr("is a color")));
  EXPECT_THAT(
      [] {
        readSeeds(threePoints(std::vector<float>{1, 0, 0}), "labels");
      },
      ThrowsMessage<InvalidInput>(HasSubstr("no attribute \"labels\"")));
}

TEST(Seeds, ACopyOfAPlaceMayHoldTheSeed) {
  const std::vector<Eigen::Vector3f> positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  const Sites sites = weldAndOrder(positions);
  const std::vector<std::int32_t> seeds = gatherSeeds(sites, {0, 0, 5});
  EXPECT_EQ(seeds[sites.siteOfPoint[1]], 5);
  EXPECT_EQ(seeds[sites.siteOfPoint[0]], 0);
}

TEST(Seeds, LabelsAreNumberedByFallingSize) {
  std::vector<std::int32_t> labels = {4, 4, 0, 9, 9, 9, 2, 2, 11};
  EXPECT_EQ(renumberBySize(labels), 4);
  EXPECT_THAT(labels, ElementsAre(3, 3, 0, 1, 1, 1, 2, 2, 4));
}

}  // namespace
}  // namespace stipple
