#include "core/geometry/nearest_points.h"

#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "core/error.h"

namespace stipple {

namespace {

struct Cloud {
  std::span<const Eigen::Vector3f> positions;
  std::size_t kdtree_get_point_count() const { return positions.size(); }
  float kdtree_get_pt(std::size_t row, std::size_t axis) const {
    return positions[row][static_cast<int>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, Index>;

// Keeps the nearest, of equally near ones the lowest row.
struct Nearest {
  using DistanceType = float;
  float squared = std::numeric_limits<float>::infinity();
  Index row = 0;

  std::size_t size() const { return squared < std::numeric_limits<float>::infinity() ? 1 : 0; }
  bool full() const { return size() == 1; }
  float worstDist() const { return std::nextafter(squared, std::numeric_limits<float>::infinity()); }
  bool addPoint(float distance, Index found) {
    if (distance < squared || (distance == squared && found < row)) {
      squared = distance;
      row = found;
    }
    return true;
  }
};

}  // namespace

std::vector<Index> findNearestPoints(std::span<const Eigen::Vector3f> positions,
                                     std::span<const Eigen::Vector3f> queries, const Progress* progress) {
  if (positions.empty()) throw InvalidInput("there are no points to be near to");
  const Cloud cloud{positions};
  Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  std::vector<Index> rows(queries.size());
  parallelFor(
      queries.size(), 512,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) {
          Nearest nearest;
          tree.findNeighbors(nearest, queries[q].data(), nanoflann::SearchParams(32, 0, false));
          rows[q] = nearest.row;
        }
      },
      progress);
  return rows;
}

}  // namespace stipple
