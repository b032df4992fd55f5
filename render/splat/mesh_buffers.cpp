#include "render/splat/mesh_buffers.h"

namespace stipple {

namespace {

constexpr Rgba8 kPlainColor{204, 204, 204, 0};

template <class T>
gl::Buffer copyOf(std::span<const T> values) {
  gl::Buffer buffer(values.size_bytes());
  buffer.write<T>(0, values);
  return buffer;
}

// Each point has `value` where there are none.
template <class T>
gl::Buffer copyOr(std::span<const T> values, std::size_t count, const T& value) {
  return values.empty() ? copyOf<T>(std::vector<T>(count, value)) : copyOf(values);
}

}  // namespace

MeshBuffers::MeshBuffers(const SurfaceMesh& mesh) : triangleCount_(mesh.triangles.size()) {
  static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Rgba8) == 4 && sizeof(Triangle) == 12);
  if (mesh.positions.empty() || mesh.triangles.empty()) return;
  positions_ = copyOf(mesh.positions);
  normals_ = copyOr<Eigen::Vector3f>(mesh.normals, mesh.positions.size(), Eigen::Vector3f::Zero());
  colors_ = copyOr(mesh.colors, mesh.positions.size(), kPlainColor);
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
