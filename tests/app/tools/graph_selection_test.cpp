#include "app/tools/graph_selection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

constexpr int kSide = 30;

Index rowAt(int x, int y) {
  return static_cast<Index>(y * kSide + x);
}

SelectionMask squareMask(int low, int high) {
  SelectionMask mask(kSide * kSide, 0);
  for (int y = low; y <= high; ++y)
    for (int x = low; x <= high; ++x) mask[rowAt(x, y)] = 1;
  return mask;
}

TEST(GraphSelection, GrowsAndShrinksByARowOfTheGrid) {
  // The 8 nearest of a point of a grid are those around it.
  const NeighborGraph graph = buildNeighborGraph(PointSet(shapes::grid(kSide)));
  EXPECT_EQ(grow(graph, squareMask(10, 15)), squareMask(9, 16));
  EXPECT_EQ(shrink(graph, squareMask(9, 16)), squareMask(10, 15));
  EXPECT_EQ(shrink(graph, grow(graph, squareMask(5, 20))), squareMask(5, 20));
  EXPECT_EQ(grow(graph, nothing(kSide * kSide)), nothing(kSide * kSide));
  EXPECT_EQ(shrink(graph, everything(kSide * kSide)), everything(kSide * kSide)) << "a rim is no border";
}

TEST(GraphSelection, GrowsFromAPointWhoseNeighborsDoNotListIt) {
  // Denser to the left: the neighbors of the last point of a line look the other way.
  std::vector<Eigen::Vector3f> line;
  float x = 0;
  for (int i = 0; i < 30; ++i, x += 0.1f + 0.02f * static_cast<float>(i)) line.emplace_back(x, 0.f, 0.f);
  const NeighborGraph graph = buildNeighborGraph(PointSet(line), {.k = 2, .gap = 3});
  SelectionMask last(line.size(), 0);
  last.back() = 1;
  EXPECT_GE(countSelected(grow(graph, last)), 2u);
}

TEST(GraphSelection, CopiesOfAPlaceGoTogether) {
  std::vector<Eigen::Vector3f> positions = shapes::grid(kSide);
  positions.push_back(positions[rowAt(4, 4)]);
  SelectionMask mask(positions.size(), 0);
  mask[rowAt(3, 4)] = 1;
  const NeighborGraph graph = buildNeighborGraph(PointSet(positions));
  const SelectionMask grown = grow(graph, mask);
  EXPECT_EQ(grown[rowAt(4, 4)], 1);
  EXPECT_EQ(grown.back(), 1);
}

// Two spheres whose surfaces are a few spacings apart, and a stray point.
TEST(GraphSelection, AConnectedPartEndsAtAGap) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(4000, 1);  // spacing .056
  for (const Eigen::Vector3f& p : shapes::randomSphere(4000, 2))
    positions.push_back(p + Eigen::Vector3f(2.5f, 0, 0));
  positions.emplace_back(0.f, 0.f, 1.6f);
  const NeighborGraph graph = buildNeighborGraph(PointSet(positions));
  for (const Index row : {Index{17}, Index{4017}}) {
    const std::vector<Index> part = findConnected(graph, row);
    EXPECT_EQ(part.size(), 4000u);
    EXPECT_EQ(part.front(), row / 4000 * 4000);
  }
  EXPECT_EQ(findConnected(graph, 8000).size(), 1u);
}

TEST(GraphSelection, FewPointsHaveAGraphToo) {
  for (const std::size_t count : {1, 2, 3}) {
    const auto all = shapes::randomSphere(count);
    const NeighborGraph graph = buildNeighborGraph(PointSet(all));
    EXPECT_EQ(findConnected(graph, 0).size(), count);
    EXPECT_EQ(countSelected(grow(graph, SelectionMask(count, 0))), 0u);
  }
}

}  // namespace
}  // namespace stipple
