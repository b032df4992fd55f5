#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "core/io/point_io.h"
#include "tests/plugins/texture_synthesis/grown_patterns.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

PointSet readScan(const std::string& path) {
  Progress progress;
  return readPoints(testData(path), progress).points;
}

// Area of the triangles of the file: an account of the surface that owes nothing to fans.
double meshArea(const PointSet& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles()) {
    const Eigen::Vector3d a = mesh.positions()[t[0]].cast<double>();
    const Eigen::Vector3d b = mesh.positions()[t[1]].cast<double>(),
                          c = mesh.positions()[t[2]].cast<double>();
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

double relativeDistance(const PointSet& points, double size, double area) {
  const PointSet grown = growPattern(points, {{"size", size}});
  return hexagonalDistance(area, countSpots(grown, grown.values<float>("species_b"), false)) / size;
}

TEST(TextureSynthesisOnScans, SpotsStandAtTheWantedDistanceOnTheBunny) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet bunny = readScan("smooth/bun_zipper_ascii.ply");
  const double area = meshArea(bunny);
  for (const double size : {0.015, 0.022}) EXPECT_NEAR(relativeDistance(bunny, size, area), 1, 0.1) << size;
}

TEST(TextureSynthesisOnScans, SpotsOfTheHeadDoNotKnowItsDensity) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet dense = readScan("smooth/igea_134k.ply");
  const double area = meshArea(dense);
  const double size = std::sqrt(area / 300);
  PointSet sparse = dense;
  std::vector<Index> removed;
  for (Index row = 0; row < dense.size(); ++row) {
    // Every fourth of a scrambled order stays.
    if ((row * 2654435761u) >> 30 != 0) removed.push_back(row);
  }
  sparse.removeRows(removed);
  ASSERT_NEAR(sparse.size(), 33500, 1500);
  const double ofDense = relativeDistance(dense, size, area), ofSparse = relativeDistance(sparse, size, area);
  EXPECT_NEAR(ofDense, 1, 0.1);
  EXPECT_NEAR(ofSparse, 1, 0.1);
  EXPECT_NEAR(ofSparse / ofDense, 1, 0.1);
}

TEST(TextureSynthesisOnScans, EveryPatternFormsOnScansWithoutTuning) {
  STIPPLE_NEEDS_TEST_DATA();
  for (const char* path : {"smooth/kitten.xyz", "cad/fandisk.off", "open/mountain_25k.obj"}) {
    const PointSet scan = readScan(path);
    for (const char* pattern : {"spots", "stripes", "zebra", "gierer_meinhardt"}) {
      const PointSet grown =
          growPattern(scan, {{"pattern", std::string(pattern)}, {"steps", std::int64_t{150}}});
      for (const float value : grown.values<float>("species_a")) ASSERT_TRUE(std::isfinite(value)) << path;
    }
  }
}

}  // namespace
}  // namespace stipple
