#include "plugins/segmentation/barriers.h"

#include <algorithm>

#include "core/geometry/creases.h"
#include "core/geometry/moments.h"
#include "plugins/segmentation/mesh_stiffness.h"

namespace stipple {

namespace {

// The noise is that of 16 neighbors: with more, the curvature of coarse scans counts as noise.
constexpr int kNoiseNeighbors = 16;

// Neighbors of the classifier: .79 in a flat place at a noise of .5 spacings with 60, .94 with 100.
int classifierNeighbors(double noise) {
  return static_cast<int>(std::clamp(30 + 140 * noise, 30.0, 100.0));
}

std::vector<float> computeClassifier(const Sites& sites, int k, const Progress* progress) {
  return classify(fitMoments(sites, k, progress));
}

std::vector<std::uint8_t> findSitesAtCreases(const SurfaceGraph& graph) {
  std::vector<std::uint8_t> atCrease(graph.size());
  for (Index i = 0; i < graph.size(); ++i) {
    const auto begin = graph.blocked.begin() + graph.offsets[i];
    const auto end = graph.blocked.begin() + graph.offsets[i + 1];
    atCrease[i] = std::find(begin, end, 1) != end;
  }
  return atCrease;
}

// Pieces that edges of some weight hold together; all edges between two pieces are blocked.
Pieces separatePieces(const SparseMatrix& stiffness, SurfaceGraph& graph) {
  SurfaceGraph strong = graph;
  for (Index i = 0; i < graph.size(); ++i) {
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      if (!(stiffness.coeff(i, graph.neighbors[e]) <= -kLeastWeight)) strong.blocked[e] = 1;
    }
  }
  Pieces pieces = findPieces(strong);
  for (Index i = 0; i < graph.size(); ++i) {
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      if (pieces.pieceOfSite[i] != pieces.pieceOfSite[graph.neighbors[e]]) graph.blocked[e] = 1;
    }
  }
  return pieces;
}

// Walls are those of the fans of `points` whatever the scheme, so that no piece depends on which edges a
// scheme has; the scheme weighs what lies between them.
void blockCreases(Terrain& terrain, const Discretization& points, const SegmentationOptions& options,
                  const Progress* progress) {
  const Discretization& d = terrain.discretization;
  terrain.k = options.k > 0 ? options.k : creaseNeighbors(terrain.noise);
  const std::vector<OneSidedPlane> planes =
      fitOneSidedPlanes(d.sites, {.k = terrain.k, .noise = terrain.noise}, progress);
  const double turn = blockingTurn(options.creaseAngle);
  // The smaller index first, so that both directions see the same bits.
  const auto isBlocked = [&](Index i, Index j) {
    return turningAngle(planes[std::min(i, j)], planes[std::max(i, j)]) > turn;
  };
  terrain.graph = buildSurfaceGraph(points, isBlocked, progress);
  terrain.atCrease = findSitesAtCreases(terrain.graph);
  const auto openShare = [&](Index i, Index j) {
    return terrain.graph.blocked[*terrain.graph.findEdge(i, j)] ? 0.0 : 1.0;
  };
  terrain.pieces = separatePieces(assembleStiffness(points, openShare, progress), terrain.graph);
  if (options.discretization.scheme == Scheme::kMesh) {
    terrain.stiffness = assembleMeshStiffness(d, points, terrain.graph, isBlocked, progress);
    return;
  }
  terrain.stiffness = assembleStiffness(d, openShare, progress);
  // Weights below 0, which other schemes have at obtuse angles, no longer cancel once edges are blocked.
  if (options.discretization.scheme != Scheme::kVoronoi) dropNegativeWeights(terrain.stiffness);
}

void slowByClassifier(Terrain& terrain, const Progress* progress) {
  const Discretization& d = terrain.discretization;
  const std::vector<double> diffusivity(terrain.classifier.begin(), terrain.classifier.end());
  terrain.stiffness = assembleStiffness(d, diffusivity, EdgeMean::kArithmetic, progress);
  terrain.graph = buildSurfaceGraph(
      d, [](Index, Index) { return false; }, progress);
  constexpr float kCrease = 0.4f;  // where the classifier takes a place for a crease
  for (Index i = 0; i < d.size(); ++i) terrain.atCrease[i] = terrain.classifier[i] < kCrease;
  terrain.pieces = findPieces(terrain.graph);
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
  } else if (options.discretization.scheme == Scheme::kMesh) {
    DiscretizationOptions byPoints = options.discretization;
    byPoints.scheme = Scheme::kVoronoi;
    PartialProgress buildingFans(progress, 0.5, 0.7);
    blockCreases(terrain, discretize(points, byPoints, buildingFans), options, &progress);
  } else {
    blockCreases(terrain, terrain.discretization, options, &progress);
  }
  return terrain;
}

}  // namespace stipple
