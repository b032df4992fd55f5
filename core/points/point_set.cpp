#include "core/points/point_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/points/row_compaction.h"

namespace stipple {

namespace {

std::size_t lengthOf(const AttributeValues& values) {
  return std::visit([](const auto& column) { return column.size(); }, values);
}

template <class T>
T absentValue() {
  if constexpr (std::is_same_v<T, Rgba8>)
    return {255, 255, 255, 255};
  else if constexpr (std::is_same_v<T, Eigen::Vector3f>)
    return Eigen::Vector3f::Zero();
  else
    return T{};
}

}  // namespace

PointSet::PointSet(std::vector<Eigen::Vector3f> positions, const Eigen::Vector3d& origin, ScalarType fileType)
    : positions_(std::move(positions)), origin_(origin), positionFileType_(fileType) {}

const Attribute* PointSet::find(std::string_view name) const {
  const auto found = std::ranges::find(attributes_, name, &Attribute::name);
  return found == attributes_.end() ? nullptr : &*found;
}

Attribute* PointSet::find(std::string_view name) {
  return const_cast<Attribute*>(std::as_const(*this).find(name));
}

const Attribute& PointSet::require(std::string_view name, AttributeType type) const {
  const Attribute* attribute = find(name);
  if (!attribute) throw InvalidInput(fmt::format("there is no attribute '{}'", name));
  if (attribute->type() != type) {
    throw InvalidInput(fmt::format("attribute '{}' is of type {}, expected {}", name,
                                   nameOf(attribute->type()), nameOf(type)));
  }
  return *attribute;
}

void PointSet::set(std::string_view name, AttributeValues values) {
  const Attribute* old = find(name);
  const bool sameType = old && old->column.values().index() == values.index();
  FileProperty file = sameType ? old->file : FileProperty{};
  if (!sameType && std::holds_alternative<std::vector<std::int32_t>>(values)) file.type = ScalarType::kInt32;
  if (!sameType && std::holds_alternative<std::vector<std::uint32_t>>(values))
    file.type = ScalarType::kUint32;
  if (!sameType && std::holds_alternative<std::vector<double>>(values)) file.type = ScalarType::kFloat64;
  set(name, std::move(values), std::move(file));
}

void PointSet::set(std::string_view name, AttributeValues values, FileProperty file) {
  insert({.name = std::string(name), .column = Column(std::move(values)), .file = std::move(file)});
}

void PointSet::insert(Attribute attribute, std::size_t position) {
  if (lengthOf(attribute.column.values()) != size()) {
    throw InvalidInput(fmt::format("attribute '{}' has {} values, expected {}", attribute.name,
                                   lengthOf(attribute.column.values()), size()));
  }
  if (Attribute* old = find(attribute.name)) {
    *old = std::move(attribute);
  } else {
    attributes_.insert(
        attributes_.begin() + static_cast<std::ptrdiff_t>(std::min(position, attributes_.size())),
        std::move(attribute));
  }
}

bool PointSet::erase(std::string_view name) {
  return std::erase_if(attributes_, [&](const Attribute& attribute) { return attribute.name == name; }) > 0;
}

void PointSet::setTriangles(std::vector<Triangle> triangles) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index corner : triangles[t]) {
      if (corner >= size()) {
        throw InvalidInput(fmt::format("triangle {} names point {}, expected below {}", t, corner, size()));
      }
    }
  }
  triangles_ = std::make_shared<std::vector<Triangle>>(std::move(triangles));
}

void PointSet::removeRows(std::span<const Index> rows) {
  if (rows.empty()) return;
  checkRowsToRemove(rows, size());
  if (!triangles_->empty()) {
    constexpr Index kGone = static_cast<Index>(-1);
    std::vector<Index> newRow(size());
    for (Index row = 0, next = 0; row < size(); ++row) {
      const bool gone = next < rows.size() && rows[next] == row;
      newRow[row] = gone ? kGone : row - next;
      if (gone) ++next;
    }
    std::vector<Triangle> kept;
    kept.reserve(triangles_->size());
    for (const Triangle& t : *triangles_) {
      const Triangle moved{newRow[t[0]], newRow[t[1]], newRow[t[2]]};
      if (std::ranges::find(moved, kGone) == moved.end()) kept.push_back(moved);
    }
    triangles_ = std::make_shared<std::vector<Triangle>>(std::move(kept));
  }
  const auto compact = [&](auto& column) { removeRowsFrom(column, rows); };
  std::visit(compact, positions_.edit());
  for (Attribute& attribute : attributes_) std::visit(compact, attribute.column.edit());
  topologyId_ = newColumnId();
}

void PointSet::appendRows(const PointSet& more) {
  if (more.origin_ != origin_) throw InvalidInput("appended points have another origin");
  if (more.size() == 0) return;
  if (&more == this) return appendRows(PointSet(more));
  for (Attribute& attribute : attributes_) {
    const Attribute* source = more.find(attribute.name);
    std::visit(
        [&](auto& column) {
          using Values = std::decay_t<decltype(column)>;
          if (source && source->type() == attribute.type()) {
            const auto& values = std::get<Values>(source->column.values());
            column.insert(column.end(), values.begin(), values.end());
          } else {
            column.resize(column.size() + more.size(), absentValue<typename Values::value_type>());
          }
        },
        attribute.column.edit());
  }
  auto& positions = std::get<std::vector<Eigen::Vector3f>>(positions_.edit());
  positions.insert(positions.end(), more.positions().begin(), more.positions().end());
  topologyId_ = newColumnId();
}

}  // namespace stipple
