#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/points/point_set.h"

namespace stipple {

/// The distinct places of a point set in a spatial (Morton) order: rows of every matrix and neighbor list.
/// Exact duplicates are welded into one site; file rows are reached through the two maps. The order depends
/// on the positions alone, not on the order of the rows.
struct Sites {
  std::vector<Eigen::Vector3f> positions;  ///< m x 3
  std::vector<Index> siteOfPoint;          ///< n: file row -> site
  std::vector<Index> pointOfSite;          ///< m: site -> its first file row

  Index size() const { return static_cast<Index>(positions.size()); }
};

/// Throws InvalidInput where a coordinate is not finite.
Sites weldAndOrder(std::span<const Eigen::Vector3f> positions);

/// Throws InvalidInput where sites that follow each other lie more than 1e15 or less than 1e-15 apart in the
/// median: floats might not hold the squares of distances in the model. Single sites may lie anywhere.
void requireUsableScale(const Sites& sites);

/// Values of the first file row of each site.
template <class T>
std::vector<T> gatherToSites(const Sites& sites, std::span<const T> pointValues) {
  std::vector<T> values(sites.size());
  for (Index s = 0; s < sites.size(); ++s) values[s] = pointValues[sites.pointOfSite[s]];
  return values;
}

/// Each file row gets the value of its site.
template <class T>
std::vector<T> scatterToPoints(const Sites& sites, std::span<const T> siteValues) {
  std::vector<T> values(sites.siteOfPoint.size());
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = siteValues[sites.siteOfPoint[p]];
  return values;
}

}  // namespace stipple
