#include "tests/support/hull_referee.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <map>

namespace stipple {

std::vector<Triangle> hullTriangles(std::span<const Eigen::Vector3f> points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> places;
  std::map<Point, Index> rowOf;
  for (const Eigen::Vector3f& p : points) {
    places.emplace_back(p.x(), p.y(), p.z());
    rowOf.emplace(places.back(), static_cast<Index>(rowOf.size()));
  }
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(places.begin(), places.end(), hull);
  std::vector<Triangle> triangles;
  for (const auto face : hull.faces()) {
    Triangle triangle{};
    std::size_t corner = 0;
    for (const auto vertex : CGAL::vertices_around_face(hull.halfedge(face), hull)) {
      triangle[corner++] = rowOf.at(hull.point(vertex));
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace stipple
