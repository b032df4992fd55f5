#include "tests/plugins/texture_synthesis/scanned_patterns.h"

#include <Eigen/Geometry>

#include "core/io/point_io.h"
#include "tests/plugins/texture_synthesis/grown_patterns.h"
#include "tests/support/test_data.h"

namespace stipple {

PointSet readScan(const std::string& path) {
  Progress progress;
  return readPoints(testData(path), progress).points;
}

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

PointSet thinned(const PointSet& points, Index share) {
  std::vector<Index> removed;
  for (Index row = 0; row < points.size(); ++row) {
    // Knuth's multiplicative hash scatters the rows that stay.
    if ((row * 2654435761u) >> 16 > 65536u / share) removed.push_back(row);
  }
  PointSet rest = points;
  rest.removeRows(removed);
  return rest;
}

double relativeSpotDistance(const PointSet& points, double size, double area) {
  const PointSet grown = growPattern(points, {{"size", size}});
  return hexagonalDistance(area, countSpots(grown, grown.values<float>("species_b"), false)) / size;
}

}  // namespace stipple
