#include "core/geometry/triangulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "core/geometry/mesh_edges.h"
#include "core/geometry/orientation.h"
#include "core/io/point_io.h"
#include "core/parallel.h"
#include "tests/support/hull_referee.h"
#include "tests/support/shapes.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

struct Result {
  Discretization d;
  std::vector<Triangle> triangles;
  MeshReport mesh;
};

Result triangulate(const PointSet& points, const TriangulationOptions& options = {}) {
  Progress progress;
  Result result{discretize(points, {.consensus = false}, progress), {}, {}};
  result.triangles = triangulateFans(result.d.sites.positions, result.d.normals, result.d.fans, options);
  windTriangles(result.d.sites.positions, sumNormals(result.d.sites, points), result.triangles);
  result.mesh = describeMesh(result.triangles, result.d.size());
  return result;
}

double volumeOf(const Result& result) {
  double sum = 0;
  for (const Triangle& t : result.triangles) {
    const auto at = [&](int c) -> Eigen::Vector3d { return result.d.sites.positions[t[c]].cast<double>(); };
    sum += at(0).dot(at(1).cross(at(2))) / 6;
  }
  return sum;
}

void expectManifold(const MeshReport& mesh) {
  EXPECT_EQ(mesh.nonManifoldEdges, 0u);
  EXPECT_EQ(mesh.inconsistentEdges, 0u);
}

void expectClosed(const MeshReport& mesh, std::int64_t eulerNumber) {
  expectManifold(mesh);
  EXPECT_EQ(mesh.boundaryEdges, 0u);
  EXPECT_EQ(mesh.nonManifoldVertices, 0u);
  EXPECT_EQ(mesh.eulerNumber, eulerNumber);
}

// The Delaunay triangulation of points of a sphere, on the sphere, is their convex hull.
TEST(Triangulation, OfRandomSpheresIsNearlyTheirHull) {
  for (const std::size_t count : {2000u, 10'000u, 60'000u}) {
    SCOPED_TRACE(count);
    const PointSet points(shapes::randomSphere(count, count));
    const Result result = triangulate(points);
    expectClosed(result.mesh, 2);
    EXPECT_EQ(result.mesh.vertices, count);
    EXPECT_GT(volumeOf(result), 0.99 * 4 / 3 * std::numbers::pi) << "turned inside out";
    std::vector<Triangle> hull = hullTriangles(result.d.sites.positions);
    std::vector<Triangle> ours = result.triangles;
    for (auto* list : {&hull, &ours}) {
      for (Triangle& t : *list) std::ranges::sort(t);
      std::ranges::sort(*list);
    }
    std::vector<Triangle> both;
    std::ranges::set_intersection(hull, ours, std::back_inserter(both));
    EXPECT_GT(both.size(), 0.995 * static_cast<double>(hull.size()));
  }
}

// Inwards, outwards, constant, of chance: the last two say nothing, and the top faces up.
TEST(Triangulation, WindsAlongTheNormalsOfTheFile) {
  const std::vector<Eigen::Vector3f> sphere = shapes::randomSphere(3000);
  std::vector<Eigen::Vector3f> inwards = sphere, chance = shapes::randomSphere(3000, 7);
  for (Eigen::Vector3f& n : inwards) n = -n;
  const auto volumeWith = [&](const std::vector<Eigen::Vector3f>& normals) {
    PointSet points(sphere);
    points.set("normal", normals);
    return volumeOf(triangulate(points));
  };
  EXPECT_GT(volumeWith(sphere), 4);
  EXPECT_LT(volumeWith(inwards), -4);
  EXPECT_GT(volumeWith(std::vector<Eigen::Vector3f>(3000, {0, 0, 1})), 4);
  EXPECT_GT(volumeWith(chance), 4);
}

TEST(Triangulation, OfASquareHasOneRim) {
  const Result random = triangulate(PointSet(shapes::randomSquare(5000)));
  expectManifold(random.mesh);
  EXPECT_EQ(random.mesh.boundaryLoops, 1u);
  EXPECT_EQ(random.mesh.eulerNumber, 1);
  const Result grid = triangulate(PointSet(shapes::grid(40)));
  expectManifold(grid.mesh);
  EXPECT_EQ(grid.triangles.size(), 2u * 39 * 39);
  EXPECT_EQ(grid.mesh.boundaryEdges, 4u * 39);
}

TEST(Triangulation, OfFewPointsOfALineAndOfCopiesIsAManifold) {
  std::vector<Eigen::Vector3f> line, copies(500, Eigen::Vector3f(1, 2, 3)),
      twice = shapes::randomSphere(3000);
  for (int i = 0; i < 100; ++i) line.emplace_back(0.1f * static_cast<float>(i), 0, 0);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 1500);
  EXPECT_TRUE(triangulate(PointSet(line)).triangles.empty());
  EXPECT_TRUE(triangulate(PointSet(copies)).triangles.empty());
  expectClosed(triangulate(PointSet(twice)).mesh, 2);
  for (std::size_t count = 1; count < 12; ++count)
    expectManifold(triangulate(PointSet(shapes::randomSphere(count))).mesh);
}

TEST(Triangulation, WithoutVotesHasOnlyWhatAllFansShare) {
  const PointSet points(shapes::randomSphere(10'000));
  const Result voted = triangulate(points), shared = triangulate(points, {.votes = false, .longestHole = 0});
  expectManifold(shared.mesh);
  EXPECT_LT(shared.triangles.size(), voted.triangles.size());
  EXPECT_GT(shared.mesh.boundaryEdges, 0u);
}

TEST(Triangulation, ClosesHolesUpToTheLengthAskedFor) {
  // The nearest points to the north pole are missing: a hole of about 40 spacings round.
  std::vector<Eigen::Vector3f> sphere = shapes::randomSphere(20'000);
  std::erase_if(sphere, [](const Eigen::Vector3f& p) { return p.z() > 0.99f; });
  const PointSet points(sphere);
  const Result open = triangulate(points), closed = triangulate(points, {.longestHole = 1000});
  EXPECT_EQ(open.mesh.boundaryLoops, 1u);
  EXPECT_GT(open.mesh.boundaryEdges, 12u);
  expectClosed(closed.mesh, 2);
}

TEST(Triangulation, DoesNotDependOnTheThreads) {
  const PointSet points(shapes::randomSphere(30'000));
  const Result onAll = triangulate(points);
  const ThreadLimit one(1);
  EXPECT_EQ(onAll.triangles, triangulate(points).triangles);
}

struct Scan {
  const char* file;
  std::int64_t eulerNumber;
};

class ClosedScans : public testing::TestWithParam<Scan> {};

// Euler numbers of the scanned things: a head, a soldier, a cat with a tail that touches it, a part without
// and one with a hole through it.
TEST_P(ClosedScans, AreClosedAndOfTheRightKind) {
  STIPPLE_NEEDS_TEST_DATA();
  Progress progress;
  PointSet points = readPoints(testData(GetParam().file), progress).points;
  points.setTriangles({});
  expectClosed(triangulate(points).mesh, GetParam().eulerNumber);
}

INSTANTIATE_TEST_SUITE_P(Scans, ClosedScans,
                         testing::Values(Scan{"smooth/igea_134k.ply", 2}, Scan{"smooth/armadillo_43k.obj", 2},
                                         Scan{"smooth/kitten.xyz", 0}, Scan{"smooth/bunny_adaptive.off", 2},
                                         Scan{"cad/fandisk.off", 2}, Scan{"cad/rocker-arm.obj", 0}),
                         [](const auto& scan) {
                           std::string name = scan.param.file;
                           std::ranges::replace_if(
                               name, [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

TEST(TriangulationOfScans, KeepsTheTrueRim) {
  STIPPLE_NEEDS_TEST_DATA();
  Progress progress;
  PointSet points = readPoints(testData("open/hemisphere.off"), progress).points;
  const MeshReport file = describeMesh(points.triangles(), points.size());
  points.setTriangles({});
  const Result result = triangulate(points);
  expectManifold(result.mesh);
  EXPECT_EQ(result.mesh.boundaryEdges, file.boundaryEdges);
  EXPECT_EQ(result.mesh.eulerNumber, file.eulerNumber);
}

}  // namespace
}  // namespace stipple
