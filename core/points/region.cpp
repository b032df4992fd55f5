#include "core/points/region.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace stipple {

namespace {

bool isSet(const Eigen::Vector3f& value) {
  return (value.array() != 0).any();
}

bool isSet(const Rgba8& value) {
  return value.r != 0 || value.g != 0 || value.b != 0;
}

template <class Number>
bool isSet(Number value) {
  return value != 0;
}

}  // namespace

Region Region::all(const PointSet& points) {
  return Region(points);
}

Region Region::fromRows(const PointSet& points, std::vector<Index> rows) {
  std::ranges::sort(rows);
  rows.erase(std::ranges::unique(rows).begin(), rows.end());
  if (!rows.empty() && rows.back() >= points.size()) {
    throw InvalidInput(fmt::format("row {} of the region is not below {}", rows.back(), points.size()));
  }
  Region region(points);
  region.rows_ = std::make_shared<const std::vector<Index>>(std::move(rows));
  return region;
}

Region Region::fromAttribute(const PointSet& points, std::string_view name) {
  const Attribute* attribute = points.find(name);
  if (!attribute) throw InvalidInput(fmt::format("there is no attribute '{}' to take a region from", name));
  std::vector<Index> rows;
  std::visit(
      [&](const auto& values) {
        for (Index row = 0; row < points.size(); ++row) {
          if (isSet(values[row])) rows.push_back(row);
        }
      },
      attribute->column.values());
  return fromRows(points, std::move(rows));
}

bool Region::contains(Index row) const {
  return rows_ ? std::ranges::binary_search(*rows_, row) : row < size_;
}

std::vector<Index> Region::rows() const {
  if (rows_) return *rows_;
  std::vector<Index> every(size_);
  std::iota(every.begin(), every.end(), Index{0});
  return every;
}

std::vector<std::uint8_t> Region::mask() const {
  if (!rows_) return std::vector<std::uint8_t>(size_, 1);
  std::vector<std::uint8_t> inside(size_, 0);
  for (const Index row : *rows_) inside[row] = 1;
  return inside;
}

}  // namespace stipple
