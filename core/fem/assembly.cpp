#include "core/fem/assembly.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

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
  double area = 0;
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
  return element;
}

// Off-diagonals of one element: share |T| grad_a . A grad_b.
template <class Apply>
void emitElement(const Discretization& d, const Triangle& t, double share, Apply&& applyTensor, Edges& edges) {
  const Element element = makeElement(d, t);
  if (!(element.area > 0)) return;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const double value = element.gradients[a].dot(applyTensor(element.gradients[b]));
    edges.push_back({t[a], t[b], -share * element.area * value});
  }
}

// Elements of all fans at a third each, with the tensor of the fan's site; sites without triangles keep their ties.
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

// Eq. (8): L~_ij = sum over the triangles of fan i of |T| A_i grad_i . grad_j; Eq. (9): the mean of L~_ij and L~_ji.
SparseMatrix assemblePaper(const Discretization& d, std::span<const Eigen::Matrix3d> tensor, const Progress* progress) {
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
    return assembleElements(d, [](Index, const Eigen::Vector3d& g) { return g; }, progress);
  }
  return assembleSpokes(d, [](Index, Index) { return 1.0; }, progress);
}

SparseMatrix assembleStiffness(const Discretization& d, std::span<const double> a, EdgeMean mean,
                               const Progress* progress) {
  if (mean == EdgeMean::kHarmonic) {
    const auto harmonic = [&](Index i, Index j) { return a[i] + a[j] > 0 ? 2 * a[i] * a[j] / (a[i] + a[j]) : 0.0; };
    return assembleSpokes(d, harmonic, progress);
  }
  if (d.options.scheme == Scheme::kElement) {
    return assembleElements(
        d, [&](Index i, const Eigen::Vector3d& g) -> Eigen::Vector3d { return a[i] * g; }, progress);
  }
  return assembleSpokes(d, [&](Index i, Index) { return a[i]; }, progress);
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

SparseMatrix expandToPoints(const Sites& sites, const SparseMatrix& stiffness) {
  const auto points = static_cast<Index>(sites.siteOfPoint.size());
  // Rows of the file at each place, ascending.
  std::vector<Index> begins(sites.size() + 1, 0), rows(points);
  for (const Index site : sites.siteOfPoint) ++begins[site + 1];
  for (Index s = 0; s < sites.size(); ++s) begins[s + 1] += begins[s];
  std::vector<Index> next(begins.begin(), begins.end() - 1);
  for (Index p = 0; p < points; ++p) rows[next[sites.siteOfPoint[p]]++] = p;

  SparseMatrix expanded(points, points);
  std::size_t total = 0;
  std::vector<std::size_t> size(points, 0);
  for (Index p = 0; p < points; ++p) {
    for (SparseMatrix::InnerIterator entry(stiffness, sites.siteOfPoint[p]); entry; ++entry) {
      size[p] += begins[static_cast<Index>(entry.col()) + 1] - begins[static_cast<Index>(entry.col())];
    }
    total += size[p];
  }
  if (total > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw InvalidInput("too many points at one place: the matrix has more than 2^31 entries");
  }
  expanded.resizeNonZeros(static_cast<Eigen::Index>(total));
  expanded.outerIndexPtr()[0] = 0;
  for (Index p = 0; p < points; ++p) {
    expanded.outerIndexPtr()[p + 1] = expanded.outerIndexPtr()[p] + static_cast<int>(size[p]);
  }
  parallelFor(points, 4096, [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<int, double>> row;
    for (std::size_t p = begin; p < end; ++p) {
      row.clear();
      const Index site = sites.siteOfPoint[p];
      const double copiesHere = begins[site + 1] - begins[site];
      for (SparseMatrix::InnerIterator entry(stiffness, site); entry; ++entry) {
        const auto column = static_cast<Index>(entry.col());
        const double copies = copiesHere * (begins[column + 1] - begins[column]);
        for (Index r = begins[column]; r < begins[column + 1]; ++r) {
          row.emplace_back(static_cast<int>(rows[r]), entry.value() / copies);
        }
      }
      std::sort(row.begin(), row.end());
      int at = expanded.outerIndexPtr()[p];
      for (const auto& [column, value] : row) {
        expanded.innerIndexPtr()[at] = column;
        expanded.valuePtr()[at++] = value;
      }
    }
  });
  return expanded;
}

std::vector<double> expandMassToPoints(const Sites& sites, std::span<const double> mass) {
  std::vector<double> copies(sites.size(), 0.0), expanded(sites.siteOfPoint.size());
  for (const Index site : sites.siteOfPoint) ++copies[site];
  for (std::size_t p = 0; p < expanded.size(); ++p) {
    expanded[p] = mass[sites.siteOfPoint[p]] / copies[sites.siteOfPoint[p]];
  }
  return expanded;
}

}  // namespace stipple
