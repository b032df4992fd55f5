#include "tests/support/scans.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/io/point_io.h"
#include "render/hierarchy/build.h"
#include "render/hierarchy/splat_radii.h"
#include "tests/support/mesh_caster.h"

namespace stipple {

const std::vector<ScannedMesh>& scannedMeshes() {
  static const std::vector<ScannedMesh> scans{{"bunny", "smooth/bunny70k_meshlab.ply"},
                                              {"igea", "smooth/igea_134k.ply"},
                                              {"armadillo", "smooth/armadillo_43k.obj"},
                                              {"lion-head", "open/lion-head.off"},
                                              {"ankylosaurus", "colour/ankylosaurus_mesh.ply"}};
  return scans;
}

namespace {

/// Without triangles that close a gap between points: those with an edge over four times the median longest
/// edge. (The underside of the ankylosaurus, an eighth of its area, is 213 such triangles.)
std::vector<Triangle> withoutBridges(const PointSet& mesh) {
  const auto longestEdge = [p = mesh.positions()](const Triangle& t) {
    return std::max({(p[t[1]] - p[t[0]]).norm(), (p[t[2]] - p[t[1]]).norm(), (p[t[0]] - p[t[2]]).norm()});
  };
  std::vector<float> lengths;
  for (const Triangle& t : mesh.triangles()) lengths.push_back(longestEdge(t));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  std::vector<Triangle> kept = mesh.triangles();
  std::erase_if(kept, [&](const Triangle& t) { return longestEdge(t) > 4 * *middle; });
  return kept;
}

}  // namespace

const char* pathOfScan(std::string_view name) {
  return std::ranges::find(scannedMeshes(), name, &ScannedMesh::name)->path;
}

MeshSubject loadMesh(const std::filesystem::path& path) {
  Progress progress;
  PointSet points = readPoints(path, progress).points;
  points.setTriangles(withoutBridges(points));
  const auto positions = points.positions();
  double area = 0;
  for (const Triangle& t : points.triangles()) {
    area += 0.5 * (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
  }
  MeshSubject subject;
  subject.spacing = static_cast<float>(std::sqrt(area / points.size()));
  subject.truth = scenes::castMesh(points, scenes::cornerNormals(points));

  // The splats know nothing of the triangles.
  PointSet alone = points;
  alone.setTriangles({});
  const std::vector<Eigen::Vector3f> normals = normalsOfFile(alone);
  LeafAttributes leaves;
  leaves.positions = positions;
  leaves.normals = normals;
  std::vector<Rgba8> colors;
  if (points.has("color")) {
    for (const Rgba8 c : points.values<Rgba8>("color")) colors.push_back({c.r, c.g, c.b, 0});
    leaves.colors = colors;
  }
  subject.byBlocks = buildHierarchy(leaves, LeafOrder::kKd);
  subject.byFans = buildByFans({positions.begin(), positions.end()}, normals, colors);
  return subject;
}

Hierarchy buildByFans(const std::vector<Eigen::Vector3f>& positions,
                      const std::vector<Eigen::Vector3f>& normals, const std::vector<Rgba8>& colors) {
  PointSet points(positions);
  if (!normals.empty()) points.set("normal", normals);
  const SurfaceEstimate estimate = estimateSurface(points);
  return buildHierarchy({.positions = positions,
                         .radii = estimate.radii,
                         .areas = estimate.areas,
                         .normals = estimate.normals,
                         .colors = colors},
                        LeafOrder::kKd);
}

}  // namespace stipple
