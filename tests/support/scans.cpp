#include "tests/support/scans.h"

#include <Eigen/Geometry>
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

MeshSubject loadMesh(const std::filesystem::path& path) {
  Progress progress;
  const PointSet points = readPoints(path, progress).points;
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
  const SurfaceEstimate estimate = estimateSurface(alone);
  leaves.normals = estimate.normals;
  leaves.radii = estimate.radii;
  leaves.areas = estimate.areas;
  subject.byFans = buildHierarchy(leaves, LeafOrder::kKd);
  return subject;
}

}  // namespace stipple
