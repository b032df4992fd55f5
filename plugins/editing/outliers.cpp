#include <algorithm>
#include <cmath>

#include "core/geometry/neighborhoods.h"
#include "core/geometry/site_sets.h"
#include "plugins/editing/editing.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 4096;

// Mean distance of each site to its neighbors, length.
std::vector<float> meanDistances(const Neighborhoods& neighborhoods, Index sites) {
  std::vector<float> means(sites, 0);
  parallelFor(sites, kGrain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const auto squared = neighborhoods.squaredDistancesOf(i);
      for (const float s : squared) means[i] += std::sqrt(s) / static_cast<float>(squared.size());
    }
  });
  return means;
}

// Median over the neighbors of a site: what is usual where it lies, so that scans of any density are treated
// alike.
std::vector<float> usualDistances(const Neighborhoods& neighborhoods, const std::vector<float>& means) {
  std::vector<float> usual(means.size());
  parallelFor(means.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<float> around;
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      around.clear();
      for (const Index j : neighborhoods.of(i)) around.push_back(means[j]);
      usual[i] = means[i];
      if (around.empty()) continue;
      const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
      std::ranges::nth_element(around, middle);
      usual[i] = *middle;
    }
  });
  return usual;
}

// Sizes of the groups that near neighbors hold together, by site.
std::vector<Index> groupSizes(const Neighborhoods& neighborhoods, const std::vector<float>& usual,
                              float factor) {
  const auto sites = static_cast<Index>(usual.size());
  SiteSets groups(sites);
  for (Index i = 0; i < sites; ++i) {
    const auto near = neighborhoods.of(i);
    const auto squared = neighborhoods.squaredDistancesOf(i);
    for (std::size_t n = 0; n < near.size(); ++n) {
      const float reach = factor * std::min(usual[i], usual[near[n]]);
      if (squared[n] <= reach * reach) groups.join(i, near[n]);
    }
  }
  std::vector<Index> counts(sites, 0), sizes(sites);
  for (Index i = 0; i < sites; ++i) ++counts[groups.rootOf(i)];
  for (Index i = 0; i < sites; ++i) sizes[i] = counts[groups.rootOf(i)];
  return sizes;
}

RunResult removeOutliers(const OneShotInput& input, Progress& progress, Report& report) {
  const auto k = static_cast<int>(input.parameters.integer("k"));
  const auto factor = static_cast<float>(input.parameters.number("factor"));
  const auto least = static_cast<Index>(input.parameters.integer("least_group"));
  const Sites sites = weldAndOrder(input.points.positions());
  progress.report(0, "finding neighbors");
  const Neighborhoods neighborhoods = findNeighborhoods(sites, {.k = k}, &progress);
  progress.report(0.7, "looking for outliers");
  const std::vector<float> means = meanDistances(neighborhoods, sites.size());
  const std::vector<float> usual = usualDistances(neighborhoods, means);
  const std::vector<Index> sizes = groupSizes(neighborhoods, usual, factor);
  std::vector<Index> rows;
  for (Index row = 0; row < input.points.size(); ++row) {
    const Index site = sites.siteOfPoint[row];
    const bool isFar = means[site] > factor * usual[site];
    if (input.region.contains(row) && (isFar || sizes[site] < least)) rows.push_back(row);
  }
  return withoutRows(input.points, std::move(rows), report);
}

}  // namespace

std::unique_ptr<Operator> makeRemoveOutliers() {
  return makeOneShot(
      {.id = "remove_outliers",
       .title = "Remove outliers",
       .help = "Removes points that are far from their neighbors, for how dense the scan is there, and small "
               "groups "
               "apart from everything else.",
       .region = RegionUse::kLimits,
       .parameters = {{.id = "k",
                       .title = "Neighbors",
                       .type = ParameterType::kInt,
                       .defaultValue = std::int64_t{12},
                       .min = 4,
                       .max = 200,
                       .help = "Nearest points that are looked at."},
                      {.id = "factor",
                       .title = "Factor",
                       .defaultValue = 4.0,
                       .min = 1.1,
                       .max = 100,
                       .help =
                           "A point goes where its neighbors are farther than so many times what is usual "
                           "among them."},
                      {.id = "least_group",
                       .title = "Least group",
                       .type = ParameterType::kInt,
                       .defaultValue = std::int64_t{8},
                       .min = 0,
                       .max = 1000000,
                       .help = "Groups of fewer points with a gap all around go. 0: none."}},
       .writes = {"position", "triangles"}},
      removeOutliers);
}

}  // namespace stipple
