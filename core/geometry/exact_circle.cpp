#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "core/geometry/local_fan.h"

namespace stipple {

int insideCircleOfOrigin(const PlanePoint& a, const PlanePoint& b, const PlanePoint& d) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  return CGAL::side_of_oriented_circle(Point(0, 0), Point(a.x, a.y), Point(b.x, b.y), Point(d.x, d.y));
}

}  // namespace stipple
