#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/io/input_file.h"
#include "core/io/number_table.h"
#include "core/progress.h"

namespace stipple {

/// One corner of a face: rows of `v`, `vt` and `vn` (kNoRow where it names none) and of the material list.
struct ObjCorner {
  static constexpr Index kNoRow = static_cast<Index>(-1);
  Index vertex = kNoRow, texture = kNoRow, normal = kNoRow, material = kNoRow;
};

/// The statements of a Wavefront OBJ file that have to do with points.
struct ObjFile {
  NumberTable vertices;  ///< x y z, or x y z red green blue
  std::vector<Eigen::Vector2f> textureCoordinates;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Triangle> triangles;
  std::vector<ObjCorner> corners;                 ///< only those that name a texture coordinate or a normal
  std::vector<std::string> materials, libraries;  ///< names of usemtl and mtllib
  std::vector<std::string> warnings;
};

/// Throws InvalidInput naming the line of a `v`, `vt` or `vn` that is no numbers.
ObjFile parseObj(const InputFile& file, Progress& progress);

}  // namespace stipple
