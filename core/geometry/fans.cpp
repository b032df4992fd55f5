#include "core/geometry/fans.h"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/geometry/local_moments.h"
#include "core/stopwatch.h"

namespace stipple {

namespace {

// Fans of one block, compressed rows.
struct BlockFans {
  std::vector<std::uint32_t> counts;
  std::vector<Index> neighbors;
  std::vector<std::uint8_t> flags;
  double neighborSeconds = 0, frameSeconds = 0, fanSeconds = 0;
};

std::uint64_t mix(std::uint64_t v) {  // splitmix64, Steele et al. 2014
  v += 0x9e3779b97f4a7c15u;
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
  return v ^ (v >> 31);
}

Eigen::Vector3f normalOf(std::span<const Eigen::Vector3f> positions, Index site,
                         std::span<const Index> neighbors) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      sumMoments(positions, site, neighbors).covariance);
  return solver.eigenvectors().col(0).cast<float>().normalized();
}

class FanBuilder {
 public:
  FanBuilder(const Sites& sites, const FanOptions& options)
      : positions_(sites.positions),
        options_(options),
        search_(sites.positions, options.k),
        shifts_(tieBreakShifts(sites.positions)) {}

  void build(Index begin, Index end, BlockFans& block, FanSet& set) const;

 private:
  struct Scratch {
    LocalFan fan;
    std::vector<PlanePoint> points;
    std::vector<Index> neighbors;
    std::vector<float> squared;
  };
  bool clipOne(Index site, const Eigen::Vector3f& normal, std::span<const Index> neighbors,
               float squaredRadius, double box, Scratch& scratch) const;
  bool growOne(Index site, const Eigen::Vector3f& normal, Scratch& scratch) const;

  // The square acts as an alpha filter: no triangle with a circumradius beyond about the distance of the 32nd
  // neighbor.
  static constexpr int kBoxNeighbors = 32;
  static constexpr double kBoxFactor = 0.75;

  std::span<const Eigen::Vector3f> positions_;
  const FanOptions& options_;
  NeighborSearch search_;
  std::vector<Eigen::Vector3f> shifts_;
};

// True where the fan is final: closed, and every point beyond the neighbors is too far to cut its cell.
bool FanBuilder::clipOne(Index site, const Eigen::Vector3f& normal, std::span<const Index> neighbors,
                         float squaredRadius, double box, Scratch& s) const {
  mapToTangentPlane(positions_, shifts_, site, normal, neighbors, options_.metric, s.points);
  if (options_.minAngle > 0) {
    s.fan.clipWithMinAngle(s.points, box, options_.minAngle);
  } else {
    s.fan.clip(s.points, box);
  }
  return !s.fan.open() && 4.0001 * s.fan.squaredReach() <= squaredRadius;
}

bool FanBuilder::growOne(Index site, const Eigen::Vector3f& normal, Scratch& s) const {
  for (int k = 2 * options_.k;; k *= 2) {
    const int wanted = std::min(k, options_.maxK);
    search_.findNearest(site, wanted, s.neighbors, s.squared);
    if (s.neighbors.empty()) return false;
    const std::size_t rim = std::min<std::size_t>(std::max(kBoxNeighbors, options_.k), s.squared.size()) - 1;
    const double box = kBoxFactor * std::sqrt(static_cast<double>(s.squared[rim]));
    if (clipOne(site, normal, s.neighbors, s.squared.back(), box, s)) return true;
    if (wanted == options_.maxK || static_cast<int>(s.neighbors.size()) < wanted) return false;
  }
}

void FanBuilder::build(Index begin, Index end, BlockFans& block, FanSet& set) const {
  ThreadStopwatch watch;
  Neighborhoods rows;
  search_.findNearest(begin, end, options_.k, rows);
  block.neighborSeconds = watch.lap();

  const auto frameCount = static_cast<std::size_t>(options_.frameNeighbors);
  for (Index site = begin; site < end; ++site) {
    const auto neighbors = rows.of(site - begin);
    set.normals[site] = normalOf(positions_, site, neighbors.first(std::min(frameCount, neighbors.size())));
  }
  block.frameSeconds = watch.lap();

  Scratch scratch;
  for (Index site = begin; site < end; ++site) {
    const auto neighbors = rows.of(site - begin);
    const Eigen::Vector3f& normal = set.normals[site];
    bool final = false;
    if (!neighbors.empty()) {
      const float squaredRadius = rows.squaredDistancesOf(site - begin).back();
      const double box = kBoxFactor * std::sqrt(static_cast<double>(squaredRadius));
      final = clipOne(site, normal, neighbors, squaredRadius, box, scratch);
      if (!final && options_.maxK > options_.k) final = growOne(site, normal, scratch);
    }
    const auto spokes = neighbors.empty() ? std::span<const LocalFan::Spoke>{} : scratch.fan.spokes();
    for (const LocalFan::Spoke& spoke : spokes) {
      block.neighbors.push_back(scratch.points[spoke.point].site);
      block.flags.push_back(spoke.gapAfter ? Fans::kGapAfter : 0);
    }
    block.counts.push_back(static_cast<std::uint32_t>(spokes.size()));
    set.fans.open[site] = neighbors.empty() || scratch.fan.open();
    set.fans.certified[site] = final;
  }
  block.fanSeconds = watch.lap();
}

void join(std::vector<BlockFans>& blocks, FanSet& set) {
  Fans& fans = set.fans;
  std::size_t total = 0;
  for (const BlockFans& block : blocks) total += block.neighbors.size();
  fans.neighbors.reserve(total);
  fans.flags.reserve(total);
  fans.offsets.reserve(fans.open.size() + 1);
  for (BlockFans& block : blocks) {
    for (const std::uint32_t count : block.counts) fans.offsets.push_back(fans.offsets.back() + count);
    fans.neighbors.insert(fans.neighbors.end(), block.neighbors.begin(), block.neighbors.end());
    fans.flags.insert(fans.flags.end(), block.flags.begin(), block.flags.end());
    set.times.neighbors += block.neighborSeconds;
    set.times.frames += block.frameSeconds;
    set.times.fans += block.fanSeconds;
    block = {};
  }
}

}  // namespace

std::vector<Eigen::Vector3f> tieBreakShifts(std::span<const Eigen::Vector3f> positions) {
  constexpr float kShare = 1e-6f;
  std::vector<Eigen::Vector3f> shifts(positions.size());
  parallelFor(positions.size(), 1 << 15, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f& p = positions[i];
      float length = 0;
      if (i > 0) length = (p - positions[i - 1]).norm();
      if (i + 1 < positions.size()) {
        const float next = (p - positions[i + 1]).norm();
        length = i > 0 ? std::min(length, next) : next;
      }
      std::uint64_t h = 0;
      for (int axis = 0; axis < 3; ++axis) {
        h = mix(h ^ std::bit_cast<std::uint32_t>(p[axis] + 0.f));  // + 0: one hash for both zeros
      }
      for (int axis = 0; axis < 3; ++axis) {
        h = mix(h);
        shifts[i][axis] = kShare * length * (static_cast<float>(h >> 40) * 0x1p-24f - 0.5f);
      }
    }
  });
  return shifts;
}

void mapToTangentPlane(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> shifts,
                       Index site, const Eigen::Vector3f& normal, std::span<const Index> neighbors,
                       Metric metric, std::vector<PlanePoint>& points) {
  const TangentBasis basis = tangentBasisOf(normal);
  points.clear();
  for (const Index j : neighbors) {
    Eigen::Vector3d d = (positions[j] - positions[site]).cast<double>();
    if (!shifts.empty()) d += (shifts[j] - shifts[site]).cast<double>();
    double x = d.dot(basis.e0), y = d.dot(basis.e1);
    const double height = d.dot(basis.normal), flat = x * x + y * y;
    double squared = flat;
    // A direction cannot be read off a neighbor straight above.
    if (!(flat > 1e-12 * height * height)) continue;
    if (metric == Metric::kUnfolded) {
      squared = flat + height * height;
      const double scale = std::sqrt(squared / flat);
      x *= scale;
      y *= scale;
    }
    points.push_back({x, y, squared, j});
  }
  // Nearly sorted in the unfolded metric.
  for (std::size_t a = 1; a < points.size(); ++a) {
    if (points[a].squaredNorm >= points[a - 1].squaredNorm) continue;
    const PlanePoint moved = points[a];
    std::size_t b = a;
    for (; b > 0 && points[b - 1].squaredNorm > moved.squaredNorm; --b) points[b] = points[b - 1];
    points[b] = moved;
  }
}

FanSet buildFans(const Sites& sites, const FanOptions& options, const Progress* progress) {
  constexpr std::size_t kBlock = 2048;
  const Stopwatch watch;
  FanSet set;
  set.normals.resize(sites.size());
  set.fans.open.resize(sites.size());
  set.fans.certified.resize(sites.size());
  const FanBuilder builder(sites, options);
  std::vector<BlockFans> blocks((sites.size() + kBlock - 1) / kBlock);
  parallelFor(
      sites.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        builder.build(static_cast<Index>(begin), static_cast<Index>(end), blocks[begin / kBlock], set);
      },
      progress);
  join(blocks, set);
  set.times.seconds = watch.seconds();
  return set;
}

}  // namespace stipple
