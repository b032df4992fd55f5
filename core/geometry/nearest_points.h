#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "core/parallel.h"

namespace stipple {

/// Answers which of `positions`, which must outlive it, is nearest to a place; of equally near ones the
/// lowest row. Threads may share it. Throws InvalidInput where there are no positions; O(n log n).
class NearestPoint {
 public:
  explicit NearestPoint(std::span<const Eigen::Vector3f> positions);
  ~NearestPoint();
  NearestPoint(const NearestPoint&) = delete;
  NearestPoint& operator=(const NearestPoint&) = delete;

  Index find(const Eigen::Vector3f& place) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

/// For each query the row of the nearest of `positions` (in space); of equally near ones the lowest. Throws
/// InvalidInput where there are no positions.
std::vector<Index> findNearestPoints(std::span<const Eigen::Vector3f> positions,
                                     std::span<const Eigen::Vector3f> queries,
                                     const Progress* progress = nullptr);

}  // namespace stipple
