#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "render/hierarchy/hierarchy.h"
#include "tests/support/ray_scenes.h"

namespace stipple {

/// A dense scan with faces, under the folder of real scans.
struct ScannedMesh {
  const char* name;
  const char* path;
};
const std::vector<ScannedMesh>& scannedMeshes();
const char* pathOfScan(std::string_view name);

/// The triangles of a file as the truth, and splats of its points alone.
struct MeshSubject {
  scenes::RaySurface truth;
  Hierarchy byBlocks;  ///< radii from blocks of leaves, as in the first picture
  Hierarchy byFans;    ///< radii from local fans
  float spacing = 0;   ///< root of the area a point stands for
};
MeshSubject loadMesh(const std::filesystem::path& path);

/// Radii, areas and missing normals from local fans. `normals` may be empty.
Hierarchy buildByFans(const std::vector<Eigen::Vector3f>& positions,
                      const std::vector<Eigen::Vector3f>& normals, const std::vector<Rgba8>& colors);

}  // namespace stipple
