#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// A set of rows of a point set. Bound to the set's topology: once rows were added or removed it no longer
/// fits. A value; copies share the list.
class Region {
 public:
  /// Every row.
  static Region all(const PointSet& points);
  /// The rows in any order, repeated ones counted once. Throws InvalidInput where one is not a row.
  static Region fromRows(const PointSet& points, std::vector<Index> rows);
  /// The rows whose value is not 0 (vector3: not the zero vector; color: not black, whatever its alpha; NaN
  /// is not 0). Throws InvalidInput where there is no such attribute.
  static Region fromAttribute(const PointSet& points, std::string_view name);

  Index count() const { return rows_ ? static_cast<Index>(rows_->size()) : size_; }
  bool isAll() const { return count() == size_; }
  /// O(log count); inner loops take mask().
  bool contains(Index row) const;
  /// Ascending.
  std::vector<Index> rows() const;
  /// One byte a row of the set: 1 inside, 0 outside.
  std::vector<std::uint8_t> mask() const;

  ColumnId topologyId() const { return topologyId_; }
  bool fits(const PointSet& points) const { return topologyId_ == points.topologyId(); }

 private:
  explicit Region(const PointSet& points) : size_(points.size()), topologyId_(points.topologyId()) {}

  std::shared_ptr<const std::vector<Index>> rows_;  // null: all rows
  Index size_;
  ColumnId topologyId_;
};

}  // namespace stipple
