#include "plugins/segmentation/mesh_stiffness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace stipple {

namespace {

// Edges of a detour that still counts as the same place: two round the other diagonal of a quadrilateral,
// three round a thin triangle.
constexpr int kDetour = 3;

struct Face {
  std::array<double, 3> halfCotangents{};  // of the edge opposite to each corner
  bool isFlat = true;
};

Face weighFace(const Discretization& mesh, const Triangle& t) {
  std::array<Eigen::Vector3d, 3> x;
  for (std::size_t c = 0; c < 3; ++c) x[c] = mesh.sites.positions[t[c]].cast<double>();
  const double twiceArea = (x[1] - x[0]).cross(x[2] - x[0]).norm();
  Face face{.halfCotangents = {}, .isFlat = !(twiceArea > 0)};
  if (face.isFlat) return face;
  for (std::size_t c = 0; c < 3; ++c) {
    const Eigen::Vector3d a = x[(c + 1) % 3] - x[c], b = x[(c + 2) % 3] - x[c];
    face.halfCotangents[c] = 0.5 * a.dot(b) / twiceArea;
  }
  return face;
}

// Faces with all three edges open are semidefinite as they are.
template <class IsOpen>
SparseMatrix assembleFaces(const Discretization& mesh, const IsOpen& isOpen) {
  std::vector<WeightedEdge> whole, cut;
  whole.reserve(3 * mesh.meshTriangles.size());
  for (const Triangle& t : mesh.meshTriangles) {
    const Face face = weighFace(mesh, t);
    if (face.isFlat) continue;
    std::array<bool, 3> open;
    for (std::size_t c = 0; c < 3; ++c) open[c] = isOpen(t[(c + 1) % 3], t[(c + 2) % 3]);
    std::vector<WeightedEdge>& edges = open[0] && open[1] && open[2] ? whole : cut;
    for (std::size_t c = 0; c < 3; ++c) {
      if (open[c]) edges.push_back({t[(c + 1) % 3], t[(c + 2) % 3], face.halfCotangents[c]});
    }
  }
  SparseMatrix ofCut = buildLaplacian(mesh.size(), std::move(cut));
  dropNegativeWeights(ofCut);
  return buildLaplacian(mesh.size(), std::move(whole)) + ofCut;
}

}  // namespace

SparseMatrix assembleMeshStiffness(const Discretization& mesh, const Discretization& points,
                                   const SurfaceGraph& graph,
                                   const std::function<bool(Index, Index)>& isBlocked,
                                   const Progress* progress) {
  const SparseMatrix faces = assembleFaces(mesh, [&](Index i, Index j) {
    if (const auto edge = graph.findEdge(i, j)) return !graph.blocked[*edge];
    return !isBlocked(i, j) && isJoined(graph, std::min(i, j), std::max(i, j), kDetour);
  });
  const SurfaceGraph ways = buildSurfaceGraph(
      mesh, [&](Index i, Index j) { return !(faces.coeff(i, j) <= -kLeastWeight); }, progress);
  const auto tie = [&](Index i, Index j) {
    if (graph.blocked[*graph.findEdge(i, j)]) return 0.0;
    return isJoined(ways, std::min(i, j), std::max(i, j), kDetour) ? 0.0 : 1.0;
  };
  return faces + assembleStiffness(points, tie, progress);
}

}  // namespace stipple
