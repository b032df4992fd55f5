#include "core/fem/assembly.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/geometry/fan_weights.h"

namespace stipple {

namespace {

using Edges = std::vector<WeightedEdge>;

// Every spoke as half an edge, times factor(site, neighbor).
template <class Factor>
SparseMatrix assembleSpokes(const Discretization& d, Factor&& factor, const Progress* progress) {
  return buildLaplacian(d.size(), collectEdges(
                                      d.size(),
                                      [&](Index begin, Index end, Edges& edges) {
                                        for (Index i = begin; i < end; ++i) {
                                          for (Index s = d.fans.offsets[i]; s < d.fans.offsets[i + 1]; ++s) {
                                            const Index j = d.fans.neighbors[s];
                                            edges.push_back({i, j, 0.5 * d.weights[s] * factor(i, j)});
                                          }
                                        }
                                      },
                                      progress));
}

struct Element {
  Eigen::Vector3d gradients[3];  // of the three linear functions
  double area = 0;               // smaller where the element is stiffer than kMostWeight
};

Element makeElement(const Discretization& d, const Triangle& t) {
  Eigen::Vector3d x[3];
  for (std::size_t c = 0; c < 3; ++c) x[c] = d.sites.positions[t[c]].cast<double>();
  const Eigen::Vector3d cross = (x[1] - x[0]).cross(x[2] - x[0]);
  Element element;
  element.area = 0.5 * cross.norm();
  if (!(element.area > 0)) return element;
  const Eigen::Vector3d turn = cross / cross.squaredNorm();
  for (std::size_t c = 0; c < 3; ++c) element.gradients[c] = turn.cross(x[(c + 2) % 3] - x[(c + 1) % 3]);
  // A needle conducts no more than the weights of fans may.
  double steepest = 0;
  for (const Eigen::Vector3d& gradient : element.gradients) {
    steepest = std::max(steepest, gradient.squaredNorm());
  }
  element.area = std::min(element.area, kMostWeight / steepest);
  return element;
}

// Off-diagonals of one element: share |T| grad_a . A grad_b.
template <class Apply>
void emitElement(const Discretization& d, const Triangle& t, double share, Apply&& applyTensor,
                 Edges& edges) {
  const Element element = makeElement(d, t);
  if (!(element.area > 0)) return;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const double value = element.gradients[a].dot(applyTensor(element.gradients[b]));
    edges.push_back({t[a], t[b], -share * element.area * value});
  }
}

// Elements of all fans at a third each, with the tensor of the fan's site; sites without triangles keep their
// ties.
template <class Apply>
SparseMatrix assembleElements(const Discretization& d, Apply&& applyTensorOf, const Progress* progress) {
  if (d.options.scheme == Scheme::kMesh) {
    Edges edges;
    edges.reserve(3 * d.meshTriangles.size());
    for (const Triangle& t : d.meshTriangles) {
      const auto meanTensor = [&](const Eigen::Vector3d& g) -> Eigen::Vector3d {
        return (applyTensorOf(t[0], g) + applyTensorOf(t[1], g) + applyTensorOf(t[2], g)) / 3;
      };
      emitElement(d, t, 1.0, meanTensor, edges);
    }
    return buildLaplacian(d.size(), std::move(edges));
  }
  const auto emit = [&](Index begin, Index end, Edges& edges) {
    for (Index i = begin; i < end; ++i) {
      const auto apply = [&](const Eigen::Vector3d& g) -> Eigen::Vector3d { return applyTensorOf(i, g); };
      const auto spokes = d.fans.of(i);
      const auto flags = d.fans.flagsOf(i);
      bool hasTriangles = false;
      for (std::size_t s = 0; s < spokes.size(); ++s) {
        if (flags[s] & Fans::kGapAfter) continue;
        hasTriangles = true;
        emitElement(d, {i, spokes[s], spokes[s + 1 == spokes.size() ? 0 : s + 1]}, 1.0 / 3, apply, edges);
      }
      if (hasTriangles) continue;
      for (std::size_t s = 0; s < spokes.size(); ++s) {
        const Eigen::Vector3d along =
            (d.sites.positions[spokes[s]] - d.sites.positions[i]).cast<double>().normalized();
        edges.push_back({i, spokes[s], 0.5 * d.weights[d.fans.offsets[i] + s] * along.dot(apply(along))});
      }
    }
  };
  return buildLaplacian(d.size(), collectEdges(d.size(), emit, progress));
}

// Eq. (8): L~_ij = sum over the triangles of fan i of |T| A_i grad_i . grad_j; Eq. (9): the mean of L~_ij and
// L~_ji.
SparseMatrix assemblePaper(const Discretization& d, std::span<const Eigen::Matrix3d> tensor,
                           const Progress* progress) {
  const auto emit = [&](Index begin, Index end, Edges& edges) {
    for (Index i = begin; i < end; ++i) {
      const auto spokes = d.fans.of(i);
      const auto flags = d.fans.flagsOf(i);
      for (std::size_t s = 0; s < spokes.size(); ++s) {
        if (flags[s] & Fans::kGapAfter) continue;
        const Triangle t{i, spokes[s], spokes[s + 1 == spokes.size() ? 0 : s + 1]};
        const Element element = makeElement(d, t);
        if (!(element.area > 0)) continue;
        const Eigen::Vector3d flux = tensor[i] * element.gradients[0];
        for (std::size_t c = 1; c < 3; ++c) {
          edges.push_back({i, t[c], -0.5 * element.area * flux.dot(element.gradients[c])});
        }
      }
    }
  };
  return buildLaplacian(d.size(), collectEdges(d.size(), emit, progress));
}

}  // namespace

SparseMatrix assembleStiffness(const Discretization& d, const Progress* progress) {
  if (d.options.scheme == Scheme::kElement) {
    return assembleElements(
        d, [](Index, const Eigen::Vector3d& g) { return g; }, progress);
  }
  return assembleSpokes(
      d, [](Index, Index) { return 1.0; }, progress);
}

SparseMatrix assembleStiffness(const Discretization& d, std::span<const double> a, EdgeMean mean,
                               const Progress* progress) {
  if (mean == EdgeMean::kHarmonic) {
    const auto harmonic = [&](Index i, Index j) {
      return a[i] + a[j] > 0 ? 2 * a[i] * a[j] / (a[i] + a[j]) : 0.0;
    };
    return assembleSpokes(d, harmonic, progress);
  }
  if (d.options.scheme == Scheme::kElement) {
    return assembleElements(
        d, [&](Index i, const Eigen::Vector3d& g) -> Eigen::Vector3d { return a[i] * g; }, progress);
  }
  return assembleSpokes(
      d, [&](Index i, Index) { return a[i]; }, progress);
}

SparseMatrix assembleStiffness(const Discretization& d, const std::function<double(Index, Index)>& factor,
                               const Progress* progress) {
  return assembleSpokes(d, factor, progress);
}

SparseMatrix assembleStiffness(const Discretization& d, std::span<const Eigen::Matrix3d> tensor,
                               const Progress* progress) {
  if (d.options.scheme == Scheme::kPaper) return assemblePaper(d, tensor, progress);
  return assembleElements(
      d, [&](Index i, const Eigen::Vector3d& g) -> Eigen::Vector3d { return tensor[i] * g; }, progress);
}

}  // namespace stipple
