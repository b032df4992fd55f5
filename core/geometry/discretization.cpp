#include "core/geometry/discretization.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/geometry/consensus.h"
#include "core/geometry/fan_weights.h"
#include "core/geometry/mesh_rings.h"
#include "core/stopwatch.h"

namespace stipple {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

FanOptions fanOptionsFor(const DiscretizationOptions& options) {
  FanOptions fans{.metric = options.metric, .minAngle = options.minAngle};
  if (options.k != 0) fans.k = options.k;
  fans.maxK = std::max(fans.k, 64);
  if (options.scheme == Scheme::kPaper) {
    // Fixed neighborhoods, projected orthogonally.
    fans.metric = Metric::kProjected;
    fans.k = options.k != 0 ? options.k : 60;
    fans.maxK = fans.k;
    fans.frameNeighbors = fans.k;
  }
  return fans;
}

// Fused loops: each stage takes the share of the wall clock that it took of the processor.
void shareOut(const FanTimes& fanTimes, DiscretizationTimes& times) {
  const double cpu = fanTimes.neighbors + fanTimes.frames + fanTimes.fans;
  const double scale = cpu > 0 ? fanTimes.seconds / cpu : 0;
  times.neighbors = {fanTimes.neighbors * scale, fanTimes.neighbors};
  times.frames = {fanTimes.frames * scale, fanTimes.frames};
  times.fans = {fanTimes.fans * scale, fanTimes.fans};
}

std::vector<Triangle> trianglesOfSites(const PointSet& points, const Sites& sites) {
  std::vector<Triangle> triangles;
  triangles.reserve(points.triangles().size());
  for (const Triangle& t : points.triangles()) {
    const Triangle moved{sites.siteOfPoint[t[0]], sites.siteOfPoint[t[1]], sites.siteOfPoint[t[2]]};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) triangles.push_back(moved);
  }
  return triangles;
}

void discretizePoints(Discretization& d, Progress& progress) {
  FanSet set = buildFans(d.sites, fanOptionsFor(d.options), &progress);
  d.normals = std::move(set.normals);
  d.fans = std::move(set.fans);
  shareOut(set.times, d.times);

  const bool vote = d.options.consensus && d.options.scheme != Scheme::kPaper;
  if (vote) {
    progress.report(0.7, "letting the fans agree");
    const Stopwatch watch;
    d.resolved = reachConsensus(d.sites.positions, d.normals, d.fans, &progress);
    d.times.consensus = {watch.seconds(), watch.cpuSeconds()};
  } else {
    d.resolved.assign(d.size(), 0);
  }

  progress.report(0.9, "weighing edges");
  const Stopwatch watch;
  FanWeights weighed = weighFans(d.sites, d.fans, d.normals, d.options, &progress);
  d.weights = std::move(weighed.weights);
  d.mass = std::move(weighed.mass);
  d.times.assembly = {watch.seconds(), watch.cpuSeconds()};
}

}  // namespace

void checkOptions(const DiscretizationOptions& options) {
  if (options.k != 0 && (options.k < 6 || options.k > 1000)) {
    throw InvalidInput(fmt::format("k is {}, expected 0 or 6 to 1000", options.k));
  }
  const double limit = options.scheme == Scheme::kPaper ? 25 : 10;
  if (!(options.minAngle >= 0 && options.minAngle <= limit * kDegree + 1e-9)) {
    throw InvalidInput(
        fmt::format("min-angle is {} degrees, expected 0 to {}", options.minAngle / kDegree, limit));
  }
}

Discretization discretize(const PointSet& points, const DiscretizationOptions& options, Progress& progress) {
  if (points.size() == 0) throw InvalidInput("there are no points to discretize");
  checkOptions(options);
  if (options.scheme == Scheme::kMesh && points.triangles().empty()) {
    throw InvalidInput("scheme mesh needs triangles and the points have none");
  }
  progress.report(0, "ordering points");
  Discretization d;
  d.options = options;
  const Stopwatch watch;
  d.sites = weldAndOrder(points.positions());
  requireUsableScale(d.sites);
  d.times.order = {watch.seconds(), watch.cpuSeconds()};
  progress.throwIfCancelled();

  progress.report(0.05, "finding neighbors and fans");
  if (options.scheme == Scheme::kMesh) {
    d.meshTriangles = trianglesOfSites(points, d.sites);
    discretizeMesh(d);
    floorMass(d.sites, d.mass);
  } else {
    discretizePoints(d, progress);
  }
  progress.report(1, "discretized");
  return d;
}

}  // namespace stipple
