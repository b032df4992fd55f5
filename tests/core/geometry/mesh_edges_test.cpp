#include "core/geometry/mesh_edges.h"

#include <gtest/gtest.h>

namespace stipple {
namespace {

const std::vector<Triangle> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// A strip of `count` quadrilaterals round a circle; half a turn makes it one-sided.
std::vector<Triangle> strip(Index count, bool isTwisted) {
  std::vector<Triangle> triangles;
  for (Index i = 0; i < count; ++i) {
    const Index a = 2 * i, b = 2 * i + 1;
    const bool isLast = i + 1 == count;
    const Index c = isLast ? (isTwisted ? 1 : 0) : a + 2, d = isLast ? (isTwisted ? 0 : 1) : b + 2;
    triangles.push_back({a, b, c});
    triangles.push_back({c, b, d});
  }
  return triangles;
}

TEST(MeshEdges, ATetrahedronIsASphere) {
  const MeshReport mesh = describeMesh(kTetrahedron, 5);
  EXPECT_EQ(mesh.vertices, 4u);
  EXPECT_EQ(mesh.edges, 6u);
  EXPECT_EQ(mesh.eulerNumber, 2);
  EXPECT_EQ(mesh.components, 1u);
  EXPECT_EQ(mesh.boundaryEdges + mesh.nonManifoldEdges + mesh.inconsistentEdges + mesh.nonManifoldVertices,
            0u);
}

TEST(MeshEdges, FindsWhatIsNoManifold) {
  std::vector<Triangle> bowTie = kTetrahedron;
  for (const Triangle& t : kTetrahedron) bowTie.push_back({t[0] + 3, t[1] + 3, t[2] + 3});
  EXPECT_EQ(describeMesh(bowTie, 7).nonManifoldVertices, 1u);
  EXPECT_EQ(describeMesh(bowTie, 7).nonManifoldEdges, 0u);
  const std::vector<Triangle> book{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_EQ(describeMesh(book, 5).nonManifoldEdges, 1u);
}

TEST(MeshEdges, CountsLoopsAndSides) {
  const MeshReport annulus = describeMesh(strip(8, false), 16), moebius = describeMesh(strip(8, true), 16);
  EXPECT_EQ(annulus.boundaryLoops, 2u);
  EXPECT_EQ(annulus.eulerNumber, 0);
  EXPECT_EQ(annulus.inconsistentEdges, 0u);
  EXPECT_EQ(moebius.boundaryLoops, 1u);
  EXPECT_EQ(moebius.eulerNumber, 0);
  EXPECT_EQ(moebius.inconsistentEdges, 1u);
}

TEST(MeshEdges, LeavesOutTrianglesWithoutArea) {
  std::vector<Triangle> triangles = kTetrahedron;
  triangles.push_back({1, 1, 2});
  EXPECT_EQ(describeMesh(triangles, 4).eulerNumber, 2);
  EXPECT_EQ(describeMesh({}, 3).eulerNumber, 0);
}

TEST(MeshEdges, AnswersForSingleEdges) {
  const MeshEdges edges(kTetrahedron, 4);
  EXPECT_EQ(edges.of(2, 1).size(), 2u);
  EXPECT_EQ(edges.of(1, 2).size(), 2u);
  EXPECT_TRUE(MeshEdges(std::vector<Triangle>{{0, 1, 2}}, 4).of(0, 3).empty());
}

}  // namespace
}  // namespace stipple
