#include "core/geometry/nearest_points.h"

#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "core/error.h"
#include "core/geometry/position_cloud.h"

namespace stipple {

namespace {

using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PositionCloud>,
                                                   PositionCloud, 3, Index>;

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

struct NearestPoint::Tree {
  explicit Tree(std::span<const Eigen::Vector3f> positions) : cloud{positions}, index(3, cloud) {}
  PositionCloud cloud;
  KdTree index;
};

NearestPoint::NearestPoint(std::span<const Eigen::Vector3f> positions) {
  if (positions.empty()) throw InvalidInput("there are no points to be near to");
  tree_ = std::make_unique<const Tree>(positions);
}
NearestPoint::~NearestPoint() = default;

Index NearestPoint::find(const Eigen::Vector3f& place) const {
  Nearest nearest;
  tree_->index.findNeighbors(nearest, place.data(), nanoflann::SearchParams(32, 0, false));
  return nearest.row;
}

std::vector<Index> findNearestPoints(std::span<const Eigen::Vector3f> positions,
                                     std::span<const Eigen::Vector3f> queries, const Progress* progress) {
  const NearestPoint nearest(positions);
  std::vector<Index> rows(queries.size());
  parallelFor(
      queries.size(), 512,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) rows[q] = nearest.find(queries[q]);
      },
      progress);
  return rows;
}

}  // namespace stipple
