#include "core/geometry/sites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/geometry/morton.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

TEST(Morton, DecodingUndoesEncoding) {
  for (const std::uint32_t v : {0u, 1u, 5u, 1000u, (1u << 21) - 1}) {
    std::uint32_t x, y, z;
    mortonDecode(mortonEncode(v, v / 2, v / 3), x, y, z);
    EXPECT_EQ(x, v);
    EXPECT_EQ(y, v / 2);
    EXPECT_EQ(z, v / 3);
  }
  EXPECT_EQ(mortonEncode(1, 0, 0), 1u);
  EXPECT_EQ(mortonEncode(0, 1, 0), 2u);
  EXPECT_EQ(mortonEncode(0, 0, 2), 32u);
}

TEST(Sites, WeldExactDuplicatesAndMapBothWays) {
  auto points = shapes::randomSphere(1000);
  const std::vector<Eigen::Vector3f> copies(points.begin(), points.begin() + 300);
  points.insert(points.end(), copies.begin(), copies.end());
  const Sites sites = weldAndOrder(points);
  ASSERT_EQ(sites.size(), 1000u);
  for (std::size_t p = 0; p < points.size(); ++p) EXPECT_EQ(sites.positions[sites.siteOfPoint[p]], points[p]);
  for (Index s = 0; s < sites.size(); ++s) {
    EXPECT_EQ(sites.siteOfPoint[sites.pointOfSite[s]], s);
    EXPECT_LT(sites.pointOfSite[s], 1000u);  // the first of the copies
  }
}

TEST(Sites, OrderDependsOnPositionsNotOnRows) {
  const auto points = shapes::randomSphere(5000);
  auto shuffled = points;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  EXPECT_EQ(weldAndOrder(points).positions, weldAndOrder(shuffled).positions);
}

TEST(Sites, FiveThousandPointsAtOnePlaceAreOneSite) {
  const std::vector<Eigen::Vector3f> points(5000, Eigen::Vector3f(1, 2, 3));
  const Sites sites = weldAndOrder(points);
  EXPECT_EQ(sites.size(), 1u);
  EXPECT_EQ(sites.pointOfSite, std::vector<Index>{0});
}

TEST(Sites, CoordinatesThatAreNotFiniteAreRefusedByName) {
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    auto points = shapes::randomSphere(100);
    points[17].y() = value;
    try {
      weldAndOrder(points);
      FAIL() << value;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("position[17]"), std::string::npos) << error.what();
    }
  }
}

TEST(Sites, ScalesWhoseSquaresAreNoFloatsAreRefused) {
  for (const float scale : {1e-30f, 1e-15f, 1e17f, 1e37f}) {
    auto points = shapes::randomSphere(1000);
    for (auto& p : points) p *= scale;
    EXPECT_THROW(requireUsableScale(weldAndOrder(points)), InvalidInput) << scale;
  }
  for (const float scale : {1e-12f, 1.f, 1e15f}) {
    auto points = shapes::randomSphere(1000);
    for (auto& p : points) p *= scale;
    points.emplace_back(1e30f, 0.f, 0.f);  // an outlier spoils nothing
    EXPECT_NO_THROW(requireUsableScale(weldAndOrder(points))) << scale;
  }
}

TEST(Sites, NoPointsNoSites) {
  EXPECT_EQ(weldAndOrder({}).size(), 0u);
}

}  // namespace
}  // namespace stipple
