#include "core/geometry/neighborhoods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

float squaredDistance(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const float x = a.x() - b.x(), y = a.y() - b.y(), z = a.z() - b.z();
  return (x * x + y * y) + z * z;
}

// Every pair measured and sorted.
std::vector<std::pair<float, Index>> bruteForce(const Sites& sites, Index site) {
  std::vector<std::pair<float, Index>> all;
  for (Index j = 0; j < sites.size(); ++j) {
    if (j != site) all.emplace_back(squaredDistance(sites.positions[j], sites.positions[site]), j);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void expectExact(const std::vector<Eigen::Vector3f>& points, int k) {
  const Sites sites = weldAndOrder(points);
  const Neighborhoods found = findNeighborhoods(sites, {.k = k});
  ASSERT_EQ(found.offsets.size(), sites.size() + 1);
  for (Index i = 0; i < sites.size(); i += std::max<Index>(1, sites.size() / 400)) {
    const auto expected = bruteForce(sites, i);
    const auto count = std::min<std::size_t>(static_cast<std::size_t>(k), expected.size());
    ASSERT_EQ(found.of(i).size(), count) << "site " << i;
    for (std::size_t j = 0; j < count; ++j) {
      ASSERT_EQ(found.squaredDistancesOf(i)[j], expected[j].first) << "site " << i << " neighbor " << j;
      // At equal distances any of them may be the last.
      if (j + 1 < count) {
        ASSERT_EQ(found.of(i)[j], expected[j].second) << "site " << i << " neighbor " << j;
      }
    }
  }
}

TEST(Neighborhoods, EqualBruteForceOnUniformPoints) {
  for (const int k : {1, 6, 16, 30, 64}) expectExact(shapes::randomSphere(4000), k);
}

TEST(Neighborhoods, EqualBruteForceWhereDensityVariesByAMillion) {
  auto points = shapes::randomSphere(3000);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] *= std::pow(10.f, -6.f * static_cast<float>(i) / static_cast<float>(points.size()));
  }
  for (const int k : {6, 16, 40}) expectExact(points, k);
}

TEST(Neighborhoods, EqualBruteForceOnOneDenseClusterInALargeBox) {
  auto points = shapes::randomSquare(6000);
  for (auto& p : points) p *= 1e-3f;
  const auto far = shapes::randomSphere(200);
  points.insert(points.end(), far.begin(), far.end());
  expectExact(points, 16);
}

TEST(Neighborhoods, EqualBruteForceOnGridsFullOfTies) {
  const Sites sites = weldAndOrder(shapes::grid(40));
  const Neighborhoods found = findNeighborhoods(sites, {.k = 16});
  for (Index i = 0; i < sites.size(); ++i) {
    const auto expected = bruteForce(sites, i);
    for (std::size_t j = 0; j < 16; ++j) ASSERT_EQ(found.squaredDistancesOf(i)[j], expected[j].first);
  }
}

TEST(Neighborhoods, FewerPointsThanK) {
  for (const std::size_t n : {1u, 2u, 3u, 10u}) expectExact(shapes::randomSphere(n), 16);
  EXPECT_TRUE(findNeighborhoods(weldAndOrder({}), {.k = 4}).neighbors.empty());
}

TEST(Neighborhoods, PointsOnALine) {
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 500; ++i) line.emplace_back(static_cast<float>(i) * 0.37f, 0.f, 0.f);
  expectExact(line, 8);
}

TEST(Neighborhoods, EpsilonAddsTheBallWhereTheKNearestAreNearer) {
  const Sites sites = weldAndOrder(shapes::randomSquare(4000));
  const float epsilon = 0.03f;  // about 11 points of the square
  const Neighborhoods found = findNeighborhoods(sites, {.k = 6, .epsilon = epsilon, .cap = 100000});
  for (Index i = 0; i < sites.size(); i += 37) {
    const auto expected = bruteForce(sites, i);
    std::size_t inBall = 0;
    while (inBall < expected.size() && expected[inBall].first < epsilon * epsilon) ++inBall;
    EXPECT_EQ(found.of(i).size(), std::max<std::size_t>(inBall, 6)) << i;
  }
}

TEST(Neighborhoods, CapThinsTheBallEvenly) {
  const Sites sites = weldAndOrder(shapes::randomSquare(4000));
  const Neighborhoods found = findNeighborhoods(sites, {.k = 6, .epsilon = 0.2f, .cap = 50});
  for (Index i = 0; i < sites.size(); i += 37) {
    EXPECT_LE(found.of(i).size(), 50u);
    EXPECT_GE(found.of(i).size(), 26u);
    EXPECT_GT(found.squaredDistancesOf(i).back(), 0.17f * 0.17f);  // it still reaches the rim
  }
}

// All but one site share a cell of the lattice. Measuring all pairs of so many takes longer than a test may.
TEST(Neighborhoods, OneOutlierVeryFarAwayCostsNothing) {
  for (const float distance : {1e9f, 1e30f}) {
    auto points = shapes::randomSphere(200000);
    points.emplace_back(distance, distance, distance);
    const Sites sites = weldAndOrder(points);
    const Neighborhoods found = findNeighborhoods(sites, {.k = 16});
    for (Index i = 0; i < sites.size() - 1; i += 20000) {
      const auto expected = bruteForce(sites, i);
      ASSERT_EQ(found.of(i).size(), 16u);
      for (std::size_t j = 0; j < 16; ++j) ASSERT_EQ(found.squaredDistancesOf(i)[j], expected[j].first);
    }
    // Squares of distances beyond 1e19 are no floats.
    EXPECT_EQ(found.of(sites.siteOfPoint.back()).size(), distance > 1e19f ? 0u : 16u);
  }
}

TEST(Neighborhoods, MedianSpacingAtAnyScaleIsANumber) {
  for (const float scale : {1e-40f, 1e-30f, 1e30f, 1e38f}) {
    auto points = shapes::randomSphere(100);
    for (auto& p : points) p *= scale;
    const float spacing = medianSpacing(weldAndOrder(points));
    EXPECT_EQ(spacing, scale < 1 ? 0 : std::numeric_limits<float>::infinity()) << scale;
  }
}

TEST(Neighborhoods, MedianSpacingOfAGridIsItsStep) {
  EXPECT_NEAR(medianSpacing(weldAndOrder(shapes::grid(21))), 0.05f, 1e-6f);
  EXPECT_EQ(medianSpacing(weldAndOrder(shapes::randomSphere(1))), 0.f);
}

TEST(Neighborhoods, AWrongKIsRefusedByName) {
  EXPECT_THROW(findNeighborhoods(weldAndOrder(shapes::grid(3)), {.k = 0}), InvalidInput);
}

}  // namespace
}  // namespace stipple
