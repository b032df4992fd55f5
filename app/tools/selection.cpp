#include "app/tools/selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "core/points/region.h"

namespace stipple {

namespace {

constexpr std::string_view kPrefix = "selection_";

SelectionMask maskOf(const PointSet& points, std::string_view attribute) {
  const Region region = regionWhereNotZero(points, attribute);
  return {region.mask().begin(), region.mask().end()};
}

std::vector<std::int32_t> columnOf(std::span<const std::uint8_t> selection) {
  std::vector<std::int32_t> column(selection.size());
  std::ranges::transform(selection, column.begin(), [](std::uint8_t s) { return s != 0 ? 1 : 0; });
  return column;
}

std::string attributeOf(std::string_view name) {
  const bool isName = !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (isName) return std::string(kPrefix).append(name);
  throw InvalidInput(fmt::format("the name of a selection is '{}', expected letters, digits and _", name));
}

std::string storedAttribute(const PointSet& points, std::string_view name) {
  std::string attribute = attributeOf(name);
  if (!points.has(attribute)) throw InvalidInput(fmt::format("there is no stored selection '{}'", name));
  return attribute;
}

}  // namespace

SelectionMask selectionOf(const PointSet& points) {
  return points.has(kSelection) ? maskOf(points, kSelection) : nothing(points.size());
}

PointSet withSelection(const PointSet& points, std::span<const std::uint8_t> selection) {
  if (selection.size() != points.size()) {
    throw InvalidInput(
        fmt::format("the selection has {} rows, the points {}", selection.size(), points.size()));
  }
  PointSet selected = points;
  if (countSelected(selection) == 0) {
    selected.erase(kSelection);
  } else {
    selected.set(kSelection, columnOf(selection));
  }
  return selected;
}

Combine combineFor(const Modifiers& modifiers) {
  if (modifiers.ctrl) return Combine::kRemove;
  return modifiers.shift ? Combine::kAdd : Combine::kReplace;
}

SelectionMask combine(SelectionMask selection, std::span<const Index> rows, Combine how) {
  if (how == Combine::kReplace) std::ranges::fill(selection, std::uint8_t{0});
  for (const Index row : rows) selection[row] = how == Combine::kRemove ? 0 : 1;
  return selection;
}

SelectionMask everything(Index size) {
  return SelectionMask(size, 1);
}

SelectionMask nothing(Index size) {
  return SelectionMask(size, 0);
}

SelectionMask invert(SelectionMask selection) {
  for (std::uint8_t& s : selection) s = s != 0 ? 0 : 1;
  return selection;
}

Index countSelected(std::span<const std::uint8_t> selection) {
  return static_cast<Index>(std::ranges::count_if(selection, [](std::uint8_t s) { return s != 0; }));
}

std::vector<Index> findInRange(const PointSet& points, std::string_view name, double low, double high) {
  const Attribute* attribute = points.find(name);
  if (!attribute) throw InvalidInput(fmt::format("there is no attribute '{}'", name));
  std::vector<Index> rows;
  std::visit(
      [&](const auto& values) {
        using T = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_arithmetic_v<T>) {
          for (Index row = 0; row < values.size(); ++row) {
            const auto value = static_cast<double>(values[row]);
            if (value >= low && value <= high) rows.push_back(row);
          }
        } else {
          throw InvalidInput(fmt::format("attribute '{}' is of type {}, expected a number", name,
                                         nameOf(attribute->type())));
        }
      },
      attribute->column.values());
  return rows;
}

PointSet storeSelection(const PointSet& points, std::string_view name) {
  const std::string attribute = attributeOf(name);
  const SelectionMask selection = selectionOf(points);
  if (countSelected(selection) == 0) throw InvalidInput("nothing is selected");
  PointSet stored = points;
  stored.set(attribute, columnOf(selection));
  return stored;
}

PointSet recallSelection(const PointSet& points, std::string_view name) {
  return withSelection(points, maskOf(points, storedAttribute(points, name)));
}

PointSet forgetSelection(const PointSet& points, std::string_view name) {
  PointSet without = points;
  without.erase(storedAttribute(points, name));
  return without;
}

std::vector<std::string> storedSelections(const PointSet& points) {
  std::vector<std::string> names;
  for (const Attribute& attribute : points.attributes()) {
    if (attribute.name.starts_with(kPrefix) && attribute.name.size() > kPrefix.size()) {
      names.push_back(attribute.name.substr(kPrefix.size()));
    }
  }
  return names;
}

}  // namespace stipple
