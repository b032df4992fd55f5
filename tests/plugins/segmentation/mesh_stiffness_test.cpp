#include "plugins/segmentation/mesh_stiffness.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

// An n x n grid, every square cut along the same diagonal.
PointSet griddedSquare(Index n, std::span<const Eigen::Vector3f> more = {}) {
  std::vector<Eigen::Vector3f> positions = shapes::grid(static_cast<int>(n));
  std::vector<Triangle> triangles;
  for (Index row = 0; row + 1 < n; ++row) {
    for (Index column = 0; column + 1 < n; ++column) {
      const Index corner = row * n + column;
      triangles.push_back({corner, corner + 1, corner + n + 1});
      triangles.push_back({corner, corner + n + 1, corner + n});
    }
  }
  positions.insert(positions.end(), more.begin(), more.end());
  PointSet points(positions);
  points.setTriangles(triangles);
  return points;
}

struct BothSchemes {
  Discretization mesh, points;
  explicit BothSchemes(const PointSet& set) {
    Progress progress;
    mesh = discretize(set, {.scheme = Scheme::kMesh}, progress);
    points = discretize(set, {}, progress);
  }
  SparseMatrix assemble(const std::function<bool(Index, Index)>& isBlocked) const {
    return assembleMeshStiffness(mesh, points, buildSurfaceGraph(points, isBlocked, nullptr), isBlocked,
                                 nullptr);
  }
};

TEST(MeshStiffness, WithoutWallsItIsTheClassicalMatrix) {
  const BothSchemes square(griddedSquare(8));
  const SparseMatrix found = square.assemble([](Index, Index) { return false; });
  EXPECT_LT((found - assembleStiffness(square.mesh)).norm(), 1e-12);
}

TEST(MeshStiffness, NothingCrossesAWall) {
  const BothSchemes square(griddedSquare(8));
  const auto& x = square.mesh.sites.positions;
  const float middle =
      0.5f * (x[square.mesh.sites.siteOfPoint[3]].x() + x[square.mesh.sites.siteOfPoint[4]].x());
  const SparseMatrix found =
      square.assemble([&](Index i, Index j) { return (x[i].x() < middle) != (x[j].x() < middle); });
  Eigen::VectorXd side(square.mesh.size());
  for (Index i = 0; i < square.mesh.size(); ++i) side[i] = x[i].x() < middle ? 0 : 1;
  EXPECT_LT((found * side).norm(), 1e-12);
  EXPECT_LT((found * Eigen::VectorXd::Ones(side.size())).norm(), 1e-12);
}

TEST(MeshStiffness, APointOnNoFaceIsTiedToItsNeighbors) {
  const std::vector<Eigen::Vector3f> grid = shapes::grid(8);
  const std::vector<Eigen::Vector3f> extra = {(0.6f * grid[27] + 0.4f * grid[28]).eval()};
  const BothSchemes square(griddedSquare(8, extra));
  const Index alone = square.mesh.sites.siteOfPoint[64];
  EXPECT_EQ(square.mesh.fans.of(alone).size(), 0u);
  EXPECT_GT(square.assemble([](Index, Index) { return false; }).coeff(alone, alone), 1);
}

}  // namespace
}  // namespace stipple
