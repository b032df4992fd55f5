#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// A choice of rows of a point set. A value: copies share the mask. The default region is every row of any
/// point set.
class Region {
 public:
  Region() = default;
  /// One entry a row, not 0 where the row belongs to the region. Throws InvalidInput where the length is not
  /// size().
  Region(const PointSet& points, std::vector<std::uint8_t> mask);

  bool isEverything() const { return !mask_; }
  bool contains(Index row) const { return !mask_ || (*mask_)[row] != 0; }
  /// Empty where the region is everything.
  std::span<const std::uint8_t> mask() const;
  /// How many rows of a point set of `size` rows are inside; these rows, ascending.
  Index count(Index size) const;
  std::vector<Index> rows(Index size) const;
  /// Rows still mean what they meant when the region was made.
  bool fits(const PointSet& points) const { return !mask_ || topologyId_ == points.topologyId(); }

 private:
  std::shared_ptr<const std::vector<std::uint8_t>> mask_;
  ColumnId topologyId_ = 0;
};

/// The rows in any order, repeated or not. Throws InvalidInput where one is not a row.
Region regionOfRows(const PointSet& points, std::span<const Index> rows);

/// The rows where the attribute is not 0 (NaN is not): a vector of any length but 0, a color other than
/// black. Throws InvalidInput where there is no such attribute.
Region regionWhereNotZero(const PointSet& points, std::string_view attribute);

/// Whether regionWhereNotZero has this row of the attribute.
bool isNotZero(const AttributeValues& values, Index row);

}  // namespace stipple
