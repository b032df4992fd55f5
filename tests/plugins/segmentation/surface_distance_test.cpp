#include "plugins/segmentation/surface_distance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stipple {
namespace {

using testing::Each;
using testing::ElementsAre;

// A chain 0 - 1 - ... - (n-1) of unit lengths; the edge after `gate` is blocked.
SurfaceGraph chain(Index size, Index gate) {
  SurfaceGraph graph;
  for (Index i = 0; i < size; ++i) {
    for (const Index j : {i - 1, i + 1}) {
      if (j >= size) continue;
      graph.neighbors.push_back(j);
      graph.lengths.push_back(1);
      graph.blocked.push_back(std::min(i, j) == gate);
    }
    graph.offsets.push_back(static_cast<Index>(graph.neighbors.size()));
  }
  return graph;
}

TEST(SurfaceDistance, StopsAtBlockedEdgesAndContinues) {
  const SurfaceGraph graph = chain(8, 4);
  std::vector<float> distance(8, kUnreached);
  const Index first[] = {0}, second[] = {4, 7};
  spreadDistance(graph, first, distance);
  EXPECT_THAT(distance, ElementsAre(0, 1, 2, 3, 4, kUnreached, kUnreached, kUnreached));
  spreadDistance(graph, second, distance);
  EXPECT_THAT(distance, ElementsAre(0, 1, 2, 1, 0, 2, 1, 0));
}

TEST(SurfaceDistance, ADiscReachesAsFarAsItsRadius) {
  EXPECT_THAT(discAround(chain(9, 5), 3, 2.5f), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(discAround(chain(9, 4), 3, 2.5f), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(discAround(chain(9, 4), 3, 0), ElementsAre(3));
}

TEST(SurfaceDistance, FillCrossesACreaseOnlyWhereItMust) {
  std::vector<std::int32_t> labels = {5, 0, 0, 0, 0, 0, 0, 6};
  fillFromNearest(chain(8, 1), labels);
  EXPECT_THAT(labels, ElementsAre(5, 5, 6, 6, 6, 6, 6, 6));
  labels = {5, 0, 0, 0, 0, 0, 0, 0};
  fillFromNearest(chain(8, 1), labels);
  EXPECT_THAT(labels, Each(5));
}

// A star whose center 0 is sealed off from its neighbors at falling distances.
TEST(SurfaceDistance, ASealedPieceTakesTheLabelOfMostOfItsBorder) {
  SurfaceGraph star;
  star.neighbors = {1, 2, 3, 0, 0, 0};
  star.offsets = {0, 3, 4, 5, 6};
  star.lengths = {3, 2, 1, 3, 2, 1};
  star.blocked.assign(6, 1);
  std::vector<std::int32_t> labels = {0, 8, 8, 4};
  fillFromNearest(star, labels);
  EXPECT_EQ(labels[0], 8);
}

TEST(SurfaceGraph, PiecesEndAtBlockedEdges) {
  const Pieces pieces = findPieces(chain(6, 2));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_THAT(pieces.of(0), ElementsAre(0, 1, 2));
  EXPECT_THAT(pieces.of(1), ElementsAre(3, 4, 5));
  EXPECT_THAT(pieces.rankOfSite, ElementsAre(0, 1, 2, 0, 1, 2));
}

TEST(SurfaceGraph, FindsEdgesAndShortDetours) {
  const SurfaceGraph graph = chain(6, 2);
  EXPECT_EQ(graph.neighbors[*graph.findEdge(3, 4)], 4u);
  EXPECT_FALSE(graph.findEdge(0, 2));
  EXPECT_TRUE(isJoined(graph, 0, 2, 2));
  EXPECT_FALSE(isJoined(graph, 0, 2, 1));
  EXPECT_FALSE(isJoined(graph, 2, 3, 6)) << "across the blocked edge";
}

}  // namespace
}  // namespace stipple
