#include "tests/support/delaunay_referee.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace stipple {

std::vector<Index> delaunayStar(const std::vector<PlanePoint>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
  Delaunay triangulation;
  const auto center = triangulation.insert(Kernel::Point_2(0, 0));
  for (const PlanePoint& p : points) triangulation.insert(Kernel::Point_2(p.x, p.y))->info() = p.site;
  std::vector<Index> star;
  auto circulator = triangulation.incident_vertices(center);
  if (circulator == nullptr) return {};
  const auto begin = circulator;
  do {
    if (triangulation.is_infinite(circulator)) return {};
    star.push_back(circulator->info());
  } while (++circulator != begin);
  return star;
}

}  // namespace stipple
