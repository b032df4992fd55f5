#include "core/geometry/orientation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "core/io/point_io.h"
#include "tests/support/shapes.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using Vectors = std::vector<Eigen::Vector3f>;

struct Oriented {
  Discretization d;
  Orientation orientation;
};

Oriented orient(const PointSet& points, const DiscretizationOptions& options = {}) {
  Progress progress;
  Discretization d = discretize(points, options, progress);
  Orientation orientation = orientNormals(d, points);
  return {std::move(d), std::move(orientation)};
}

// Sites whose normal points against the outside that is given for each site.
template <class OutsideOf>
Index countInward(const Oriented& o, OutsideOf&& outsideOf) {
  Index inward = 0;
  for (Index i = 0; i < o.d.size(); ++i) inward += o.orientation.normals[i].dot(outsideOf(i)) < 0;
  return inward;
}

Index countInward(const Oriented& o, const Eigen::Vector3f& center = Eigen::Vector3f::Zero()) {
  return countInward(o, [&](Index i) -> Eigen::Vector3f { return o.d.sites.positions[i] - center; });
}

// Of a scan with faces, read without its normals: the sites whose sign differs from that of the sum of the
// faces round them. Sites that no face touches do not count.
struct MeshComparison {
  Index compared = 0, wrong = 0;
  Orientation orientation;
};

MeshComparison compareWithFaces(const std::string& file) {
  Progress progress;
  PointSet points = readPoints(testData(file), progress).points;
  points.erase("normal");
  const Oriented o = orient(points);
  std::vector<Eigen::Vector3d> sums(o.d.size(), Eigen::Vector3d::Zero());
  for (const Triangle& t : points.triangles()) {
    const auto p = points.positions();
    const Eigen::Vector3f cross = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
    for (const Index corner : t) sums[o.d.sites.siteOfPoint[corner]] += cross.cast<double>();
  }
  MeshComparison comparison{.orientation = o.orientation};
  for (Index i = 0; i < o.d.size(); ++i) {
    if (sums[i].isZero()) continue;
    ++comparison.compared;
    comparison.wrong += o.orientation.normals[i].cast<double>().dot(sums[i]) < 0;
  }
  return comparison;
}

// Random points of the surface of the cube [-1, 1]^3.
Vectors randomCube(std::size_t count) {
  Vectors points = shapes::randomSquare(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = 2 * points[i].x() - 1, y = 2 * points[i].y() - 1, side = i % 2 == 0 ? 1.f : -1.f;
    const std::size_t axis = i / 2 % 3;
    points[i] = axis == 0   ? Eigen::Vector3f(side, x, y)
                : axis == 1 ? Eigen::Vector3f(x, side, y)
                            : Eigen::Vector3f(x, y, side);
  }
  return points;
}

TEST(Orientation, OfARandomSphereIsOutward) {
  for (const std::size_t n : {300u, 20000u}) {
    const Oriented o = orient(PointSet(shapes::randomSphere(n)));
    EXPECT_EQ(countInward(o), 0u);
    EXPECT_GT(o.orientation.votes, 2 * o.d.size());  // a triangulation has about three edges a site
    EXPECT_EQ(o.orientation.conflicts, 0u);
    for (Index i = 0; i < o.d.size(); ++i) {
      const auto& normal = o.orientation.normals[i];
      EXPECT_TRUE(normal == o.d.normals[i] || normal == -o.d.normals[i]);
    }
  }
}

TEST(Orientation, OfACubeIsOutward) {
  EXPECT_EQ(countInward(orient(PointSet(randomCube(12000)))), 0u);
}

TEST(Orientation, EveryPartFacesOutward) {
  Vectors points = shapes::randomSphere(2000, 1);
  const Eigen::Vector3f apart(5, 0, 0);
  for (const Eigen::Vector3f& p : shapes::randomSphere(2000, 2)) points.push_back(p + apart);
  const Oriented o = orient(PointSet(points));
  const auto outside = [&](Index i) -> Eigen::Vector3f {
    const Eigen::Vector3f& p = o.d.sites.positions[i];
    return p.x() < 2.5f ? p : Eigen::Vector3f(p - apart);
  };
  EXPECT_EQ(countInward(o, outside), 0u);
}

TEST(Orientation, DoesNotDependOnRowsOrThreads) {
  Progress progress;
  Vectors points = randomCube(4000);
  const Vectors expected = orient(PointSet(points)).orientation.normals;
  std::shuffle(points.begin(), points.end(), std::mt19937(3));
  EXPECT_EQ(orient(PointSet(points)).orientation.normals, expected);
  const ThreadLimit limit(1);
  EXPECT_EQ(orient(PointSet(points)).orientation.normals, expected);
}

TEST(Orientation, NeedsNoConsensus) {
  EXPECT_EQ(countInward(orient(PointSet(shapes::randomSphere(8000)), {.consensus = false})), 0u);
  EXPECT_EQ(countInward(orient(PointSet(shapes::randomSphere(8000)), {.scheme = Scheme::kPaper})), 0u);
}

TEST(Orientation, NormalsOfTheFileWin) {
  const Vectors sphere = shapes::randomSphere(3000);
  Vectors inward(sphere.size());
  std::ranges::transform(sphere, inward.begin(), [](const auto& p) -> Eigen::Vector3f { return -3 * p; });
  PointSet points(sphere);
  points.set("normal", inward);
  EXPECT_EQ(countInward(orient(points)), 3000u);

  // Where they are missing or broken, those of the neighbors decide.
  for (std::size_t i = 0; i < inward.size(); ++i) {
    if (i % 3 == 0) inward[i].setZero();
    if (i % 3 == 1) inward[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  points.set("normal", inward);
  EXPECT_EQ(countInward(orient(points)), 3000u);
}

TEST(Orientation, NormalsOfTheFileThatMakeNoSenseAreIgnored) {
  const Vectors sphere = shapes::randomSphere(3000);
  PointSet points(sphere);
  points.set("normal", Vectors(sphere.size(), Eigen::Vector3f::UnitX()));
  EXPECT_EQ(countInward(orient(points)), 0u);
  points.set("normal", shapes::randomSphere(sphere.size(), 7));
  EXPECT_EQ(countInward(orient(points)), 0u);

  Vectors anySign = sphere;
  std::mt19937 random(5);
  for (Eigen::Vector3f& v : anySign) v *= random() % 2 == 0 ? 1.f : -1.f;
  points.set("normal", anySign);
  EXPECT_EQ(countInward(orient(points)), 0u);
  points.set("normal", std::vector<float>(sphere.size(), 1.f));
  EXPECT_EQ(countInward(orient(points)), 0u);
}

TEST(Orientation, TheWindingOfFacesDecidesForSchemeMesh) {
  PointSet points(Vectors{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Eigen::Vector3f center(0.25f, 0.25f, 0.25f);
  points.setTriangles({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  EXPECT_EQ(countInward(orient(points, {.scheme = Scheme::kMesh}), center), 0u);
  points.setTriangles({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}});
  EXPECT_EQ(countInward(orient(points, {.scheme = Scheme::kMesh}), center), 4u);
}

TEST(Orientation, SheetsFaceUp) {
  Vectors points = shapes::randomSquare(2000);
  for (const Eigen::Vector3f& p : shapes::randomSquare(2000, 2)) points.emplace_back(p.x(), p.y(), 2.f);
  const Oriented o = orient(PointSet(points));
  EXPECT_EQ(countInward(o, [](Index) { return Eigen::Vector3f(0, 0, 1); }), 0u);
}

TEST(Orientation, AVerticalWallHasOneSide) {
  Vectors points = shapes::randomSquare(2000);
  for (Eigen::Vector3f& p : points) p = {p.x(), 0.f, p.y()};
  const Oriented o = orient(PointSet(points));
  EXPECT_EQ(countInward(o, [](Index) { return Eigen::Vector3f(0, 1, 0); }), 0u);
}

TEST(Orientation, OfDegenerateSetsIsAUnitVectorASite) {
  Vectors line;
  for (int i = 0; i < 100; ++i) line.emplace_back(static_cast<float>(i), 0.f, 0.f);
  const Vectors cases[] = {{{1, 2, 3}},
                           {{1, 2, 3}, {1, 2, 4}},
                           {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                           Vectors(5000, Eigen::Vector3f(1, 1, 1)),
                           line};
  for (const Vectors& points : cases) {
    const Oriented o = orient(PointSet(points));
    ASSERT_EQ(o.orientation.normals.size(), o.d.size());
    for (const auto& normal : o.orientation.normals) EXPECT_NEAR(normal.norm(), 1.f, 1e-5f);
  }
}

TEST(Orientation, EqualsTheFacesOfScans) {
  STIPPLE_NEEDS_TEST_DATA();
  for (const char* file : {"smooth/bunny_tristrips.ply", "cad/rocker-arm.obj"}) {
    const MeshComparison c = compareWithFaces(file);
    EXPECT_GT(c.compared, 9000u) << file;
    EXPECT_EQ(c.wrong, 0u) << file;
    EXPECT_EQ(c.orientation.conflicts, 0u) << file;
  }
}

TEST(Orientation, EqualsTheFacesOfASharpModel) {
  STIPPLE_NEEDS_TEST_DATA();
  const MeshComparison c = compareWithFaces("cad/fandisk.off");
  EXPECT_EQ(c.compared, 7229u);
  EXPECT_LE(c.wrong, 1u);  // two in ten thousand
}

}  // namespace
}  // namespace stipple
