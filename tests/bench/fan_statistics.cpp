// How much a fan depends on the number of neighbors that it is chosen from (Fig. 2 of the paper), how many
// fans are certified, and how far fans agree with each other.
#include <fmt/format.h>

#include <algorithm>

#include "core/geometry/consensus.h"
#include "core/geometry/fan_votes.h"
#include "core/io/point_io.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

std::vector<Index> sortedNeighbors(const Fans& fans, Index site) {
  std::vector<Index> neighbors(fans.of(site).begin(), fans.of(site).end());
  std::ranges::sort(neighbors);
  return neighbors;
}

// Percentage of sites for which `holds`.
template <class Holds>
double percentage(const Fans& fans, Holds&& holds) {
  Index count = 0;
  for (Index i = 0; i < fans.size(); ++i) count += holds(i);
  return 100.0 * count / std::max<Index>(fans.size(), 1);
}

double percentageOfSame(const Fans& a, const Fans& b) {
  return percentage(a, [&](Index i) { return sortedNeighbors(a, i) == sortedNeighbors(b, i); });
}

double percentageOfSame(const Fans& a, const Fans& b, const Fans& c) {
  return percentage(a, [&](Index i) {
    const auto neighbors = sortedNeighbors(a, i);
    return neighbors == sortedNeighbors(b, i) && neighbors == sortedNeighbors(c, i);
  });
}

double percentageCertified(const Fans& fans) {
  return percentage(fans, [&](Index i) { return fans.certified[i] != 0; });
}

// Exactly k neighbors; the tangent plane by `frameNeighbors` of them, or by all where that is 0 (the paper).
Fans fansOf(const Sites& sites, Metric metric, int k, int frameNeighbors) {
  return buildFans(sites, {.metric = metric,
                           .frameNeighbors = frameNeighbors == 0 ? k : frameNeighbors,
                           .k = k,
                           .maxK = k})
      .fans;
}

void printSameAtAnyK(const char* name, const char* kind, const Sites& sites, Metric metric, int frame) {
  const Fans at20 = fansOf(sites, metric, 20, frame), at40 = fansOf(sites, metric, 40, frame),
             at60 = fansOf(sites, metric, 60, frame);
  fmt::print("{:<16}{:>9}  {:<34}{:>9.2f}{:>9.2f}{:>9.2f}", name, sites.size(), kind,
             percentageOfSame(at20, at60), percentageOfSame(at40, at60), percentageOfSame(at20, at40, at60));
  // The certificate holds where distances in the plane are those in space.
  if (metric == Metric::kUnfolded) {
    fmt::print("{:>12.2f}{:>9.2f}{:>9.2f}", percentageCertified(at20), percentageCertified(at40),
               percentageCertified(at60));
  }
  fmt::print("\n");
}

void printAgreement(const char* name, const Sites& sites) {
  FanSet set = buildFans(sites, {});
  const double certified = percentageCertified(set.fans), before = 100 * shareOfConsistentTriangles(set.fans);
  const auto resolved = reachConsensus(sites.positions, set.normals, set.fans);
  fmt::print("{:<16}{:>9}{:>12.2f}{:>14.2f}{:>14.2f}{:>14.2f}\n", name, sites.size(), certified, before,
             100 * shareOfConsistentTriangles(set.fans),
             percentage(set.fans, [&](Index i) { return resolved[i] != 0; }));
}

struct Cloud {
  const char* name;
  Sites sites;
};

std::vector<Cloud> readClouds() {
  const std::string folder = STIPPLE_TEST_DATA;
  std::vector<Cloud> clouds;
  Progress progress;
  for (const auto& [name, file] : {std::pair{"bunny", "/smooth/bunny_tristrips.ply"},
                                   {"igea", "/smooth/igea_134k.ply"},
                                   {"armadillo", "/smooth/armadillo_43k.obj"},
                                   {"rocker-arm", "/cad/rocker-arm.obj"}}) {
    clouds.push_back({name, weldAndOrder(readPoints(folder + file, progress).points.positions())});
  }
  clouds.push_back({"random sphere", weldAndOrder(shapes::randomSphere(100'000))});
  return clouds;
}

}  // namespace
}  // namespace stipple

int main() {
  using namespace stipple;
  const std::vector<Cloud> clouds = readClouds();
  fmt::print("% of points with the same neighbors in their fans, and of certified fans, at k = 20, 40, 60\n");
  fmt::print("{:<16}{:>9}  {:<34}{:>9}{:>9}{:>9}{:>12}{:>9}{:>9}\n", "cloud", "points", "tangent plane",
             "20 = 60", "40 = 60", "all same", "cert. 20", "40", "60");
  for (const Cloud& c : clouds) {
    printSameAtAnyK(c.name, "of 16 neighbors, unfolded (ours)", c.sites, Metric::kUnfolded, 16);
    printSameAtAnyK(c.name, "of 16 neighbors, projected", c.sites, Metric::kProjected, 16);
    printSameAtAnyK(c.name, "of k neighbors, projected (paper)", c.sites, Metric::kProjected, 0);
  }
  fmt::print(
      "\nDefault fans (k = 24, uncertified ones up to 64): % certified, % of triangles that stand in\n");
  fmt::print("the fans of all three corners before and after consensus, % of sites resolved\n");
  fmt::print("{:<16}{:>9}{:>12}{:>14}{:>14}{:>14}\n", "cloud", "points", "certified", "consistent", "after",
             "resolved");
  for (const Cloud& c : clouds) printAgreement(c.name, c.sites);
}
