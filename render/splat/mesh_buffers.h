#pragma once

#include "render/appearance/surface_mesh.h"
#include "render/gl/buffer.h"
#include "render/gl/vertex_array.h"

namespace stipple {

/// A mesh on the graphics card, laid out as shaders/mesh.vert reads it.
class MeshBuffers {
 public:
  /// Throws IoError where the card has no room for it.
  explicit MeshBuffers(const SurfaceMesh& mesh);
  void draw() const;

 private:
  gl::Buffer positions_, normals_, colors_, triangles_;
  gl::VertexArray corners_;
  std::size_t triangleCount_ = 0;
};

}  // namespace stipple
