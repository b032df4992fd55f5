// Relative L2 errors of (M + L) u = M f on random points of the unit sphere, beside the cotangent matrix of
// the convex hull: the worst over five samples of error / error of the hull, and the errors of the first.
#include <fmt/format.h>

#include <algorithm>

#include "tests/support/harmonic_errors.h"
#include "tests/support/hull_referee.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

using Errors = std::array<double, 3>;

Errors errorsOf(const PointSet& points, const DiscretizationOptions& options) {
  Progress progress;
  return harmonicErrors(discretize(points, options, progress));
}

void printRows(std::size_t count) {
  struct Row {
    const char* name;
    DiscretizationOptions options;
    Errors first{}, worstRatio{};
  };
  std::array<Row, 5> rows{{{"hull", {.scheme = Scheme::kMesh}},
                           {"consensus", {}},
                           {"without", {.consensus = false}},
                           {"element", {.scheme = Scheme::kElement}},
                           {"paper", {.scheme = Scheme::kPaper}}}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto positions = shapes::randomSphere(count, seed);
    PointSet points(positions);
    points.setTriangles(hullTriangles(positions));
    Errors hull{};
    for (Row& row : rows) {
      const Errors errors = errorsOf(points, row.options);
      if (&row == &rows[0]) hull = errors;
      if (seed == 1) row.first = errors;
      for (std::size_t h = 0; h < 3; ++h)
        row.worstRatio[h] = std::max(row.worstRatio[h], errors[h] / hull[h]);
    }
  }
  for (const Row& row : rows) {
    fmt::print("{:>7} {:<10} {:.5f} {:.5f} {:.5f}   {:5.2f} {:5.2f} {:5.2f}\n", count, row.name, row.first[0],
               row.first[1], row.first[2], row.worstRatio[0], row.worstRatio[1], row.worstRatio[2]);
  }
}

}  // namespace
}  // namespace stipple

int main() {
  fmt::print(" points scheme     Y10     Y32     Y40       worst of five against the hull\n");
  for (const std::size_t count : {2000u, 8000u, 32000u, 128000u}) stipple::printRows(count);
}
