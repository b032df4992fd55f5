#include "render/splat/mesh_buffers.h"

namespace stipple {

namespace {

template <class T>
gl::Buffer copyOf(std::span<const T> values) {
  gl::Buffer buffer(values.size_bytes());
  buffer.write<T>(0, values);
  return buffer;
}

}  // namespace

MeshBuffers::MeshBuffers(const SurfaceMesh& mesh) : triangleCount_(mesh.triangles.size()) {
  static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Rgba8) == 4 && sizeof(Triangle) == 12);
  if (mesh.positions.empty() || mesh.triangles.empty()) return;
  positions_ = copyOf(mesh.positions);
  normals_ = copyOf(mesh.normals);
  colors_ = copyOf(mesh.colors);
  triangles_ = copyOf(mesh.triangles);
  corners_.setAttribute(0, gl::VertexFormat::kFloat3, positions_);
  corners_.setAttribute(1, gl::VertexFormat::kFloat3, normals_);
  corners_.setAttribute(2, gl::VertexFormat::kUnitByte4, colors_);
  corners_.setIndices(triangles_);
}

void MeshBuffers::draw() const {
  if (triangles_.size() > 0) corners_.drawIndexed(3 * triangleCount_);
}

}  // namespace stipple
