#include "app/document/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <random>
#include <thread>
#include <unordered_map>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

// A half cylinder of radius 1 about the y axis: unrolled, it is a plane of width pi.
PointSet halfCylinder(int around, int along) {
  std::vector<Eigen::Vector3f> positions;
  for (int i = 0; i <= around; ++i) {
    for (int j = 0; j <= along; ++j) {
      const double angle = std::numbers::pi * i / around;
      positions.emplace_back(std::cos(angle), double(j) / along, std::sin(angle));
    }
  }
  return PointSet(std::move(positions));
}

TEST(SurfaceDistance, FollowsTheSurfaceAndNotTheSpace) {
  const PointSet points = halfCylinder(100, 30);
  const SurfaceDistance surface(points);
  const Index start = surface.findNearest({1.0f, 0.5f, 0.0f});
  const float radius = 2.5f;  // the other rim is 2 away in space, pi along the surface
  std::vector<float> distance(points.size(), INFINITY);
  float last = 0;
  for (const Reached& reached : surface.findWithin(start, radius)) {
    EXPECT_GE(reached.distance, last);
    last = reached.distance;
    distance[reached.site] = reached.distance;
  }
  for (Index site = 0; site < surface.sites().size(); ++site) {
    const Eigen::Vector3f& p = surface.sites().positions[site];
    const double geodesic = std::hypot(std::atan2(p.z(), p.x()), p.y() - 0.5);
    if (geodesic > radius) {
      EXPECT_EQ(distance[site], INFINITY);
    }
    // Steps to the 8 cells around are at most 46.7 degrees apart here, so paths are at most 1 / cos(23.4
    // degrees) = 1.09 times longer; chords are a little shorter than arcs.
    if (geodesic < radius / 1.09) {
      EXPECT_NEAR(distance[site], geodesic, 0.09 * geodesic);
    }
  }
}

TEST(SurfaceDistance, FindsAShortestPath) {
  const PointSet points = halfCylinder(100, 30);
  const SurfaceDistance surface(points);
  const Index start = surface.findNearest({1, 0.5f, 0}), end = surface.findNearest({-1, 0.2f, 0});
  const std::vector<Index> path = surface.findPath(start, end);
  ASSERT_GT(path.size(), 10u);
  EXPECT_EQ(path.front(), start);
  EXPECT_EQ(path.back(), end);
  float length = 0;
  for (std::size_t p = 1; p < path.size(); ++p)
    length += (surface.sites().positions[path[p]] - surface.sites().positions[path[p - 1]]).norm();
  // As long as what the search from the start alone says.
  const auto reached = surface.findWithin(start, 4);
  const auto found = std::ranges::find(reached, end, &Reached::site);
  ASSERT_NE(found, reached.end());
  EXPECT_NEAR(length, found->distance, 1e-4f);
  EXPECT_EQ(surface.findPath(start, start), std::vector<Index>{start});
}

TEST(SurfaceDistance, FindsNoPathWhereNoneLeads) {
  std::vector<Eigen::Vector3f> two;
  for (int i = 0; i < 40; ++i)
    two.emplace_back(0.01f * static_cast<float>(i) + (i < 20 ? 0.f : 50.f), 0.f, 0.f);
  const SurfaceDistance surface{PointSet(two)};
  EXPECT_TRUE(surface.findPath(surface.findNearest({0, 0, 0}), surface.findNearest({51, 0, 0})).empty());
}

TEST(SurfaceDistance, FindsTheNearestSite) {
  const SurfaceDistance surface(PointSet({{0, 0, 0}, {1, 0, 0}, {5, 0, 0}}));
  EXPECT_EQ(surface.sites().positions[surface.findNearest({4, 1, 0})].x(), 5);
  EXPECT_EQ(surface.findWithin(surface.findNearest({0, 0, 0}), 0.5f).size(), 1u);
}

// Dijkstra as it is written in books.
std::vector<Reached> findWithinByTheBook(const SurfaceDistance& surface, Index start, float radius) {
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::unordered_map<Index, float> best = {{start, 0.0f}};
  std::vector<Reached> reached;
  front.emplace(0.0f, start);
  const auto& positions = surface.sites().positions;
  while (!front.empty()) {
    const auto [distance, site] = front.top();
    front.pop();
    if (distance > best[site]) continue;
    reached.push_back({site, distance});
    for (const Index neighbor : surface.neighborsOf(site)) {
      const Eigen::Vector3f step = positions[neighbor] - positions[site];
      const float through =
          distance + std::sqrt(step.x() * step.x() + step.y() * step.y() + step.z() * step.z());
      if (through > radius) continue;
      const auto [known, isNew] = best.try_emplace(neighbor, through);
      if (!isNew && known->second <= through) continue;
      known->second = through;
      front.emplace(through, neighbor);
    }
  }
  return reached;
}

bool sameReach(const std::vector<Reached>& a, const std::vector<Reached>& b) {
  return std::ranges::equal(a, b, [](const Reached& left, const Reached& right) {
    return left.site == right.site && left.distance == right.distance;
  });
}

// On a grid many sites are equally far.
TEST(SurfaceDistance, FindsWhatTheBookFinds) {
  for (const PointSet& points : {PointSet(shapes::randomSphere(3000)), PointSet(shapes::grid(50))}) {
    const SurfaceDistance surface(points);
    std::mt19937 random(1);
    for (int i = 0; i < 50; ++i) {
      const Index start = std::uniform_int_distribution<Index>(0, surface.sites().size() - 1)(random);
      const float radius = 0.02f * static_cast<float>(i);
      ASSERT_TRUE(sameReach(surface.findWithin(start, radius), findWithinByTheBook(surface, start, radius)));
    }
  }
}

TEST(SurfaceDistance, ThreadsMayShareIt) {
  const SurfaceDistance surface(PointSet(shapes::randomSphere(2000)));
  const auto alone = surface.findWithin(5, 0.5f);
  std::vector<std::jthread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 20; ++i) EXPECT_TRUE(sameReach(surface.findWithin(5, 0.5f), alone));
    });
  }
}

TEST(SurfaceDistance, KnowsAllRowsOfASite) {
  const SurfaceDistance surface(PointSet({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
  const auto rows = surface.pointsOf(surface.findNearest({0, 0, 0}));
  EXPECT_EQ(std::vector<Index>(rows.begin(), rows.end()), (std::vector<Index>{0, 2}));
}

}  // namespace
}  // namespace stipple
