#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/geometry/sites.h"
#include "core/progress.h"

namespace stipple {

/// Neighbors of every site, nearest first, without the site itself. Compressed rows: those of site i are
/// [offsets[i], offsets[i+1]).
struct Neighborhoods {
  std::vector<std::size_t> offsets;     ///< m + 1
  std::vector<Index> neighbors;         ///< site indices
  std::vector<float> squaredDistances;  ///< in length^2, parallel to neighbors

  std::span<const Index> of(Index site) const {
    return {neighbors.data() + offsets[site], offsets[site + 1] - offsets[site]};
  }
  std::span<const float> squaredDistancesOf(Index site) const {
    return {squaredDistances.data() + offsets[site], offsets[site + 1] - offsets[site]};
  }
};

struct NeighborhoodOptions {
  int k = 30;         ///< at least the k nearest (fewer only where the set has fewer)
  float epsilon = 0;  ///< and, where the k-th is nearer than this, all within this distance
  int cap = 200;      ///< a ball with more members keeps every r-th of those beyond the k nearest
};

/// Exact k nearest neighbors, ties by index; with epsilon the rule of Section 6 of the paper. Sites farther
/// than floats can square (1e19) are not found.
Neighborhoods findNeighborhoods(const Sites& sites, const NeighborhoodOptions& options,
                                const Progress* progress = nullptr);

/// Answers neighbor queries about positions in the order of weldAndOrder, which must outlive it; safe to
/// share between threads. A hashed grid over the Morton order, a kd-tree where the density varies too much
/// for it.
class NeighborSearch {
 public:
  /// `typicalK` only tunes the cell size.
  NeighborSearch(std::span<const Eigen::Vector3f> positions, int typicalK);
  ~NeighborSearch();
  NeighborSearch(NeighborSearch&&) noexcept;
  NeighborSearch& operator=(NeighborSearch&&) noexcept;

  /// Appends the k nearest of each site in [begin, end), nearest first, itself excluded: compressed rows.
  void findNearest(Index begin, Index end, int k, Neighborhoods& rows) const;
  /// The k nearest of one site.
  void findNearest(Index site, int k, std::vector<Index>& neighbors,
                   std::vector<float>& squaredDistances) const;
  /// All others within the radius, nearest first.
  void findWithin(Index site, float radius, std::vector<Index>& neighbors,
                  std::vector<float>& squaredDistances) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// body(site, neighbors, squaredDistances) with the k nearest of every site, on all threads. Neighborhoods
/// never stand in memory as a whole.
template <class Body>
void forNeighborhoods(const Sites& sites, const NeighborSearch& search, int k, const Progress* progress,
                      const Body& body) {
  constexpr std::size_t kGrain = 1024;
  parallelFor(
      sites.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        Neighborhoods rows;
        search.findNearest(static_cast<Index>(begin), static_cast<Index>(end), k, rows);
        for (auto site = static_cast<Index>(begin); site < end; ++site) {
          const auto row = static_cast<Index>(site - begin);
          body(site, rows.of(row), rows.squaredDistancesOf(row));
        }
      },
      progress);
}

/// Median distance to the nearest other site; 0 below two sites. Beyond the scale that requireUsableScale
/// asks for, 0 or infinite.
float medianSpacing(const Sites& sites);

}  // namespace stipple
