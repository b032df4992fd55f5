#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/tools/pointer_event.h"
#include "core/points/point_set.h"

namespace stipple {

/// One entry a row, 1 where the row is selected, else 0.
using SelectionMask = std::vector<std::uint8_t>;

/// The selection of a point set is this attribute (int, 0 or 1). There is none where nothing is selected.
inline constexpr std::string_view kSelection = "selection";

/// Where the attribute is not 0; of any type, since files may bring their own.
SelectionMask selectionOf(const PointSet& points);
/// The points with this selection. Throws InvalidInput where the length is not theirs.
PointSet withSelection(const PointSet& points, std::span<const std::uint8_t> selection);

/// What new rows do to a selection.
enum class Combine { kReplace, kAdd, kRemove };
/// Shift adds, ctrl removes.
Combine combineFor(const Modifiers& modifiers);
SelectionMask combine(SelectionMask selection, std::span<const Index> rows, Combine how);

SelectionMask everything(Index size);
SelectionMask nothing(Index size);
SelectionMask invert(SelectionMask selection);
Index countSelected(std::span<const std::uint8_t> selection);

/// Rows, ascending, whose value lies in [low, high]; NaN does not. Throws InvalidInput where there is no such
/// attribute or it is a vector or a color.
std::vector<Index> findInRange(const PointSet& points, std::string_view attribute, double low, double high);

/// Named selections are attributes too: selection_<name>. Names are letters, digits and _; InvalidInput for
/// others, and where there is none of this name or, to store, nothing is selected.
PointSet storeSelection(const PointSet& points, std::string_view name);
PointSet recallSelection(const PointSet& points, std::string_view name);
PointSet forgetSelection(const PointSet& points, std::string_view name);
std::vector<std::string> storedSelections(const PointSet& points);

}  // namespace stipple
