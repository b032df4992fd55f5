#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/neighborhoods.h"
#include "plugins/editing/editing.h"

namespace stipple {

namespace {

// A fixed order that has nothing to do with where the sites lie (the finalizer of SplitMix64).
std::uint64_t rankOf(Index site) {
  std::uint64_t x = site + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Sites no two of which are nearer than the spacing, none of the others being as far from all of them (Cook
// 1986, by throwing darts at the points).
std::vector<std::uint8_t> scatterDarts(const Sites& sites, float spacing, Progress& progress) {
  const NeighborSearch search(sites.positions, 16);
  std::vector<Index> order(sites.size()), near;
  std::vector<float> squared;
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, rankOf);
  enum : std::uint8_t { kOpen, kKept, kGone };
  std::vector<std::uint8_t> state(sites.size(), kOpen);
  for (std::size_t n = 0; n < order.size(); ++n) {
    if (n % 4096 == 0) {
      progress.throwIfCancelled();
      progress.report(0.1 + 0.9 * static_cast<double>(n) / static_cast<double>(order.size()),
                      "choosing points");
    }
    if (state[order[n]] != kOpen) continue;
    state[order[n]] = kKept;
    search.findWithin(order[n], spacing, near, squared);
    for (const Index site : near) state[site] = kGone;
  }
  for (std::uint8_t& s : state) s = s == kKept;
  return state;
}

RunResult resample(const OneShotInput& input, Progress& progress, Report& report) {
  const Sites sites = weldAndOrder(input.points.positions());
  requireUsableScale(sites);
  progress.report(0, "measuring the spacing");
  double spacing = input.parameters.number("spacing");
  if (spacing == 0) spacing = 2.0 * medianSpacing(sites);
  const std::vector<std::uint8_t> isKept = scatterDarts(sites, static_cast<float>(spacing), progress);
  std::vector<Index> rows;
  for (Index row = 0; row < input.points.size(); ++row) {
    const Index site = sites.siteOfPoint[row];
    if (!isKept[site] || sites.pointOfSite[site] != row) rows.push_back(row);
  }
  report.values.push_back({"spacing", spacing});
  return withoutRows(input.points, std::move(rows), report);
}

}  // namespace

std::unique_ptr<Operator> makeResample() {
  return makeOneShot(
      {.id = "resample",
       .title = "Resample",
       .help = "Keeps points that are at least the spacing apart and lie evenly, with all that they "
               "carry; copies of one place go.",
       .parameters = {{.id = "spacing",
                       .title = "Spacing",
                       .unit = Unit::kLength,
                       .defaultValue = 0.0,
                       .min = 0,
                       .help = "Least distance of the points that stay; 0: twice what it is now."}},
       .writes = {"position", "triangles"}},
      resample);
}

}  // namespace stipple
