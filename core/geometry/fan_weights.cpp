#include "core/geometry/fan_weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

struct FanSums {
  std::vector<double> weights;  // half sums of cotangents a spoke
  double area = 0;              // of the triangles
  double cell = 0;              // Voronoi cell

  void measure(std::span<const Eigen::Vector3d> spokes, std::span<const std::uint8_t> flags);
  bool cellIsSound(std::span<const Eigen::Vector3d> spokes) const;
};

void FanSums::measure(std::span<const Eigen::Vector3d> spokes, std::span<const std::uint8_t> flags) {
  weights.assign(spokes.size(), 0.0);
  area = cell = 0;
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    if (flags[s] & Fans::kGapAfter) continue;
    const std::size_t t = s + 1 == spokes.size() ? 0 : s + 1;
    const Eigen::Vector3d &a = spokes[s], &b = spokes[t];
    const double twiceArea = a.cross(b).norm();
    if (!(twiceArea > 0)) continue;
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b);
    const double halfCotAtA = 0.5 * (aa - ab) / twiceArea, halfCotAtB = 0.5 * (bb - ab) / twiceArea;
    weights[s] += halfCotAtB;
    weights[t] += halfCotAtA;
    cell += 0.25 * (aa * halfCotAtB + bb * halfCotAtA);
    area += 0.5 * twiceArea;
  }
}

// A star has no negative part but by rounding. A fan that consensus changed may have: small ones are given to
// the neighbors, as in every partition by circumcenters, and cells still add up to the area.
bool FanSums::cellIsSound(std::span<const Eigen::Vector3d> spokes) const {
  constexpr double kSmallShare = 0.2;
  double negative = 0;
  for (std::size_t s = 0; s < spokes.size(); ++s)
    negative += std::max(0.0, -weights[s]) * spokes[s].squaredNorm() / 4;
  return cell > 0 && negative <= kSmallShare * cell;
}

class FanWeigher {
 public:
  FanWeigher(const Sites& sites, const Fans& fans, std::span<const Eigen::Vector3f> normals,
             const DiscretizationOptions& options, FanWeights& result)
      : positions_(sites.positions),
        fans_(fans),
        normals_(normals),
        paper_(options.scheme == Scheme::kPaper),
        unfolded_(options.metric == Metric::kUnfolded),
        result_(result) {}

  void weigh(Index begin, Index end) const;

 private:
  void inSpace(Index site, std::vector<Eigen::Vector3d>& spokes) const;
  void inPlane(Index site, std::vector<Eigen::Vector3d>& spokes) const;

  std::span<const Eigen::Vector3f> positions_;
  const Fans& fans_;
  std::span<const Eigen::Vector3f> normals_;
  bool paper_, unfolded_;
  FanWeights& result_;
};

void FanWeigher::inSpace(Index site, std::vector<Eigen::Vector3d>& spokes) const {
  spokes.clear();
  for (const Index j : fans_.of(site)) spokes.push_back((positions_[j] - positions_[site]).cast<double>());
}

void FanWeigher::inPlane(Index site, std::vector<Eigen::Vector3d>& spokes) const {
  inSpace(site, spokes);
  const Eigen::Vector3d normal = normals_[site].cast<double>();
  for (Eigen::Vector3d& d : spokes) {
    const double length = d.norm();
    d -= normal * normal.dot(d);
    const double flat = d.norm();
    if (unfolded_ && !paper_ && flat > 0) d *= length / flat;
  }
}

void FanWeigher::weigh(Index begin, Index end) const {
  std::vector<Eigen::Vector3d> spokes;
  FanSums sums;
  for (Index site = begin; site < end; ++site) {
    const auto flags = fans_.flagsOf(site);
    double* const weights = result_.weights.data() + fans_.offsets[site];
    paper_&& unfolded_ ? inSpace(site, spokes) : inPlane(site, spokes);
    sums.measure(spokes, flags);
    const bool useCell = !paper_ && !fans_.open[site] && sums.cellIsSound(spokes);
    result_.mass[site] = useCell ? sums.cell : sums.area / 3;
    for (std::size_t s = 0; s < flags.size(); ++s) {
      weights[s] = std::clamp(sums.weights[s], paper_ ? -kMostWeight : 0.0, kMostWeight);
    }
  }
}

// A site that nothing pulls at, from its own fan or another's, is tied to its spokes: together they conduct
// like a strip as wide as it is long.
void tieStrays(const Fans& fans, std::vector<double>& weights) {
  std::vector<std::uint8_t> held(fans.size(), 0);
  for (Index site = 0; site < fans.size(); ++site) {
    for (Index s = fans.offsets[site]; s < fans.offsets[site + 1]; ++s) {
      if (weights[s] != 0) held[site] = held[fans.neighbors[s]] = 1;
    }
  }
  for (Index site = 0; site < fans.size(); ++site) {
    if (held[site]) continue;
    const Index begin = fans.offsets[site], end = fans.offsets[site + 1];
    std::fill(weights.begin() + begin, weights.begin() + end,
              1.0 / static_cast<double>(std::max<Index>(end - begin, 1)));
  }
}

}  // namespace

void floorMass(const Sites& sites, std::vector<double>& mass) {
  const double mean = parallelSum(mass.size(), 8192,
                                  [&](std::size_t begin, std::size_t end) {
                                    double sum = 0;
                                    for (std::size_t i = begin; i < end; ++i) sum += mass[i];
                                    return sum;
                                  }) /
                      static_cast<double>(std::max<std::size_t>(mass.size(), 1));
  double floor = 1e-3 * mean;
  if (!(floor > 0)) {
    const double spacing = medianSpacing(sites);
    floor = spacing > 0 ? spacing * spacing : 1.0;
  }
  for (double& m : mass) m = std::max(m, floor);
}

FanWeights weighFans(const Sites& sites, const Fans& fans, std::span<const Eigen::Vector3f> normals,
                     const DiscretizationOptions& options, const Progress* progress) {
  FanWeights result;
  result.weights.resize(fans.neighbors.size());
  result.mass.resize(fans.size());
  const FanWeigher weigher(sites, fans, normals, options, result);
  parallelFor(
      fans.size(), 4096,
      [&](std::size_t begin, std::size_t end) {
        weigher.weigh(static_cast<Index>(begin), static_cast<Index>(end));
      },
      progress);
  tieStrays(fans, result.weights);
  floorMass(sites, result.mass);
  return result;
}

}  // namespace stipple
