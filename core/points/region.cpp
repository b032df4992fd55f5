#include "core/points/region.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stipple {

namespace {

template <class T>
bool differsFromZero(const T& value) {
  if constexpr (std::is_same_v<T, Rgba8>)
    return value.r != 0 || value.g != 0 || value.b != 0;
  else if constexpr (std::is_same_v<T, Eigen::Vector3f>)
    return !value.isZero(0);
  else
    return value != T{0};
}

}  // namespace

Region::Region(const PointSet& points, std::vector<std::uint8_t> mask) : topologyId_(points.topologyId()) {
  if (mask.size() != points.size()) {
    throw InvalidInput(fmt::format("the region has {} entries, expected {}", mask.size(), points.size()));
  }
  mask_ = std::make_shared<const std::vector<std::uint8_t>>(std::move(mask));
}

std::span<const std::uint8_t> Region::mask() const {
  return mask_ ? std::span<const std::uint8_t>(*mask_) : std::span<const std::uint8_t>();
}

Index Region::count(Index size) const {
  return mask_ ? static_cast<Index>(mask_->size() - std::ranges::count(*mask_, 0)) : size;
}

std::vector<Index> Region::rows(Index size) const {
  std::vector<Index> inside;
  for (Index row = 0; row < size; ++row) {
    if (contains(row)) inside.push_back(row);
  }
  return inside;
}

Region regionOfRows(const PointSet& points, std::span<const Index> rows) {
  std::vector<std::uint8_t> mask(points.size());
  for (const Index row : rows) {
    if (row >= points.size()) {
      throw InvalidInput(fmt::format("row {} of the region is not below {}", row, points.size()));
    }
    mask[row] = 1;
  }
  return Region(points, std::move(mask));
}

Region regionWhereNotZero(const PointSet& points, std::string_view attribute) {
  const Attribute* found = points.find(attribute);
  if (!found) throw InvalidInput(fmt::format("the region attribute '{}' is not in the points", attribute));
  std::vector<std::uint8_t> mask(points.size());
  std::visit(
      [&](const auto& values) {
        for (std::size_t row = 0; row < values.size(); ++row)
          mask[row] = differsFromZero(values[row]) ? 1 : 0;
      },
      found->column.values());
  return Region(points, std::move(mask));
}

bool isNotZero(const AttributeValues& values, Index row) {
  return std::visit([&](const auto& column) { return differsFromZero(column[row]); }, values);
}

}  // namespace stipple
