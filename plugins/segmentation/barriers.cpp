#include "plugins/segmentation/barriers.h"

#include <algorithm>

#include "core/geometry/creases.h"
#include "core/geometry/moments.h"

namespace stipple {

namespace {

// The noise is that of 16 neighbors: with more, the curvature of coarse scans counts as noise.
constexpr int kNoiseNeighbors = 16;

// Neighbors of the classifier: .79 in a flat place at a noise of .5 spacings with 60, .94 with 100.
int classifierNeighbors(double noise) {
  return static_cast<int>(std::clamp(30 + 140 * noise, 30.0, 100.0));
}

std::vector<float> computeClassifier(const Sites& sites, int k, const Progress* progress) {
  return classify(fitMoments(sites, findNeighborhoods(sites, {.k = k}, progress), progress));
}

// Weights below 0, which schemes other than voronoi have at obtuse angles, no longer cancel once edges are
// blocked: they are dropped, so that the matrix stays semidefinite.
void dropNegativeWeights(SparseMatrix& stiffness) {
  for (Eigen::Index row = 0; row < stiffness.rows(); ++row) {
    double diagonal = 0;
    for (SparseMatrix::InnerIterator entry(stiffness, row); entry; ++entry) {
      if (entry.col() == row) continue;
      entry.valueRef() = std::min(entry.value(), 0.0);
      diagonal -= entry.value();
    }
    stiffness.coeffRef(row, row) = diagonal;
  }
}

void blockCreases(Terrain& terrain, const SegmentationOptions& options, const Progress* progress) {
  const Discretization& d = terrain.discretization;
  terrain.k = options.k > 0 ? options.k : creaseNeighbors(terrain.noise);
  const std::vector<OneSidedPlane> planes =
      fitOneSidedPlanes(d.sites, {.k = terrain.k, .noise = terrain.noise}, progress);
  const double turn = blockingTurn(options.creaseAngle);
  // The smaller index first, so that both directions see the same bits.
  const auto isBlocked = [&](Index i, Index j) {
    return turningAngle(planes[std::min(i, j)], planes[std::max(i, j)]) > turn;
  };
  terrain.graph = buildSurfaceGraph(d, isBlocked, progress);
  terrain.stiffness = assembleStiffness(
      d, [&](Index i, Index j) { return isBlocked(i, j) ? 0.0 : 1.0; }, progress);
  if (options.discretization.scheme != Scheme::kVoronoi) dropNegativeWeights(terrain.stiffness);
  for (Index i = 0; i < d.size(); ++i) {
    const auto begin = terrain.graph.blocked.begin() + terrain.graph.offsets[i];
    const auto end = terrain.graph.blocked.begin() + terrain.graph.offsets[i + 1];
    terrain.atCrease[i] = std::find(begin, end, 1) != end;
  }
}

void slowByClassifier(Terrain& terrain, const Progress* progress) {
  const Discretization& d = terrain.discretization;
  const std::vector<double> diffusivity(terrain.classifier.begin(), terrain.classifier.end());
  terrain.stiffness = assembleStiffness(d, diffusivity, EdgeMean::kArithmetic, progress);
  terrain.graph = buildSurfaceGraph(
      d, [](Index, Index) { return false; }, progress);
  constexpr float kCrease = 0.4f;  // where the classifier takes a place for a crease
  for (Index i = 0; i < d.size(); ++i) terrain.atCrease[i] = terrain.classifier[i] < kCrease;
}

}  // namespace

Terrain buildTerrain(const PointSet& points, const SegmentationOptions& options, Progress& progress) {
  Terrain terrain;
  PartialProgress discretizing(progress, 0, 0.5);
  terrain.discretization = discretize(points, options.discretization, discretizing);
  const Sites& sites = terrain.discretization.sites;
  terrain.atCrease.assign(sites.size(), 0);
  progress.report(0.5, "creases");
  terrain.noise = estimateNoise(sites, kNoiseNeighbors);
  if (options.diffusivity == Diffusivity::kClassifier || options.seeding == Seeding::kFlattest) {
    terrain.k = options.k > 0 ? options.k : classifierNeighbors(terrain.noise);
    terrain.classifier = computeClassifier(sites, terrain.k, &progress);
  }
  if (options.diffusivity == Diffusivity::kClassifier) {
    slowByClassifier(terrain, &progress);
  } else {
    blockCreases(terrain, options, &progress);
  }
  progress.report(0.9, "pieces");
  terrain.pieces = findPieces(terrain.graph);
  return terrain;
}

}  // namespace stipple
