#include "plugins/triangulation/triangulation.h"

#include <fmt/format.h>

#include "core/geometry/mesh_edges.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangulation.h"
#include "plugins/api/fe_parameters.h"

namespace stipple {

namespace {

std::vector<Parameter> triangulationParameters() {
  return withFeParameters({{.id = "fill_holes",
                            .title = "Fill holes",
                            .type = ParameterType::kInt,
                            .defaultValue = std::int64_t{12},
                            .min = 0,
                            .max = 1000,
                            .help = "Holes with at most so many edges are closed. 0: none."}});
}

void describe(const std::vector<Triangle>& triangles, Index sites, Report& report) {
  const MeshReport mesh = describeMesh(triangles, sites);
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  report.values = {{"triangles", count(triangles.size())},
                   {"components", count(mesh.components)},
                   {"euler_number", mesh.eulerNumber},
                   {"boundary_edges", count(mesh.boundaryEdges)},
                   {"boundary_loops", count(mesh.boundaryLoops)},
                   {"non_manifold_edges", count(mesh.nonManifoldEdges)},
                   {"non_manifold_vertices", count(mesh.nonManifoldVertices)},
                   {"unused_points", count(sites - mesh.vertices)}};
  if (mesh.inconsistentEdges > 0) {
    report.warnings.push_back(
        fmt::format("the surface has one side only: along {} edges both triangles run the same way",
                    mesh.inconsistentEdges));
  }
}

RunResult triangulate(const OneShotInput& input, Progress& progress, Report& report) {
  DiscretizationOptions options = discretizationOptions(input.parameters);
  const bool votes = options.consensus;
  options.consensus = false;  // the triangles are voted for below
  PartialProgress preparing(progress, 0, 0.7);
  const Discretization d = discretize(input.points, options, preparing);
  progress.report(0.7, "letting the fans agree");
  const auto longestHole = static_cast<int>(input.parameters.integer("fill_holes"));
  std::vector<Triangle> triangles = triangulateFans(d.sites.positions, d.normals, d.fans,
                                                    {.votes = votes, .longestHole = longestHole}, &progress);
  windTriangles(d.sites.positions, sumNormals(d.sites, input.points), triangles);
  if (triangles.empty()) throw InvalidInput("no three points agree on a triangle");
  describe(triangles, d.size(), report);
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner = d.sites.pointOfSite[corner];
  }
  RunResult result{.points = input.points};
  result.points.setTriangles(std::move(triangles));
  progress.report(1, "triangulated");
  return result;
}

}  // namespace

std::unique_ptr<Operator> makeTriangulation() {
  return makeOneShot(
      {.id = "triangulation",
       .title = "Triangulation",
       .help =
           "Joins the local Delaunay fans into one set of triangles: those of all three fans stand, disputed "
           "ones are voted for (with consensus off they are left out), no edge gets more than two.",
       .parameters = triangulationParameters(),
       .writes = {"triangles"}},
      triangulate);
}

}  // namespace stipple
