#include "core/points/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/points/row_compaction.h"

namespace stipple {

namespace {

// Rows of `after`, below its appended ones, whose bits changed; nothing where holding the whole column is
// smaller.
template <class T>
std::optional<std::vector<Index>> findChangedRows(const std::vector<T>& before, const std::vector<T>& after,
                                                  std::span<const Index> removed) {
  constexpr std::size_t kBlock =
      256;  // rows that are compared at once: most of a column is usually untouched
  const std::size_t kept = before.size() - removed.size();
  const std::size_t most = kept * sizeof(T) / (sizeof(T) + sizeof(Index));
  const auto same = [&](std::size_t from, std::size_t to, std::size_t count) {
    return std::memcmp(static_cast<const void*>(&before[from]), static_cast<const void*>(&after[to]),
                       count * sizeof(T)) == 0;
  };
  std::vector<Index> rows;
  std::size_t from = 0;
  for (std::size_t gap = 0; gap <= removed.size(); ++gap, ++from) {
    const std::size_t end = gap < removed.size() ? removed[gap] : before.size();
    while (from < end) {
      const std::size_t count = std::min(kBlock, end - from);
      if (!same(from, from - gap, count)) {
        for (std::size_t row = from; row < from + count; ++row) {
          if (!same(row, row - gap, 1)) rows.push_back(static_cast<Index>(row - gap));
        }
        if (rows.size() > most) return std::nullopt;
      }
      from += count;
    }
  }
  return rows;
}

template <class T>
std::vector<T> gather(const std::vector<T>& column, std::span<const Index> rows) {
  std::vector<T> values;
  values.reserve(rows.size());
  for (const Index row : rows) values.push_back(column[row]);
  return values;
}

// Attributes that can stay where they are while others come and go: the same on both sides but for values,
// and in the same order.
std::vector<std::string> findStaying(const PointSet& before, const PointSet& after) {
  std::vector<std::string> staying;
  std::size_t next = 0;
  for (const Attribute& now : after.attributes()) {
    const Attribute* old = before.find(now.name);
    if (!old || old->type() != now.type() || old->file != now.file) continue;
    const auto position = static_cast<std::size_t>(old - before.attributes().data());
    if (position < next) continue;
    next = position + 1;
    staying.push_back(now.name);
  }
  return staying;
}

std::size_t bytesOf(const Column& column) {
  return std::visit([](const auto& values) { return values.size() * sizeof(values[0]); }, column.values());
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

void throwUnlessHas(const PointSet& points, const std::string& name, AttributeType type) {
  const Attribute* attribute = points.find(name);
  if (!attribute) throw InvalidInput(fmt::format("the edit does not fit: there is no attribute '{}'", name));
  if (attribute->type() != type) {
    throw InvalidInput(fmt::format("the edit does not fit: attribute '{}' is of type {}, expected {}", name,
                                   nameOf(attribute->type()), nameOf(type)));
  }
}

}  // namespace

Edit difference(const PointSet& before, const PointSet& after, std::span<const Index> removedRows) {
  checkRowsToRemove(removedRows, before.size());
  const auto kept = before.size() - static_cast<Index>(removedRows.size());
  if (after.size() < kept) {
    throw InvalidInput(fmt::format("the new state has {} points, expected at least {}", after.size(), kept));
  }
  if (after.origin() != before.origin()) throw InvalidInput("the new state has another origin");

  Edit edit;
  edit.kept_ = kept;
  edit.appended_ = after.size() - kept;
  edit.removed_ = std::make_shared<std::vector<Index>>(removedRows.begin(), removedRows.end());
  edit.addPositions(before, after);
  edit.addAttributes(before, after);
  const bool sameTriangles =
      after.sharedTriangles() == before.sharedTriangles() || after.triangles() == before.triangles();
  if (!sameTriangles || edit.changesRows()) edit.triangles_ = after.sharedTriangles();
  if (edit.changesRows()) edit.topologyId_ = newColumnId();
  return edit;
}

// Nothing where the whole column should be held instead.
std::optional<Edit::Patch> Edit::makePatch(const std::string& name, const Column& before, const Column& after,
                                           std::span<const Index> removed) {
  return std::visit(
      [&](const auto& old) -> std::optional<Patch> {
        using Values = std::decay_t<decltype(old)>;
        const auto& now = std::get<Values>(after.values());
        auto rows = findChangedRows(old, now, removed);
        if (!rows) return std::nullopt;
        const auto firstAppended = now.begin() + static_cast<std::ptrdiff_t>(old.size() - removed.size());
        return Patch{.name = name,
                     .rows = std::make_shared<std::vector<Index>>(*rows),
                     .values = Column(gather(now, *rows)),
                     .ends = Column(Values(firstAppended, now.end()))};
      },
      before.values());
}

void Edit::addPositions(const PointSet& before, const PointSet& after) {
  if (!changesRows() && before.positionColumn().id() == after.positionColumn().id()) return;
  std::optional<Patch> patch = makePatch("", before.positionColumn(), after.positionColumn(), *removed_);
  if (!patch) {
    positions_ = after.positionColumn();
  } else if (changesRows() || !patch->rows->empty()) {
    patches_.push_back(std::move(*patch));
  }
}

void Edit::addAttributes(const PointSet& before, const PointSet& after) {
  std::vector<std::string> staying = findStaying(before, after);
  std::erase_if(staying, [&](const std::string& name) {
    const Column &old = before.find(name)->column, &now = after.find(name)->column;
    if (!changesRows() && old.id() == now.id()) return false;
    std::optional<Patch> patch = makePatch(name, old, now, *removed_);
    if (patch && (changesRows() || !patch->rows->empty())) patches_.push_back(std::move(*patch));
    return !patch;
  });
  for (const Attribute& attribute : before.attributes()) {
    if (!contains(staying, attribute.name)) leaving_.push_back(attribute.name);
  }
  const auto attributes = after.attributes();
  for (std::size_t position = 0; position < attributes.size(); ++position) {
    if (!contains(staying, attributes[position].name)) held_.push_back({attributes[position], position});
  }
}

bool Edit::empty() const {
  return !changesRows() && !positions_ && patches_.empty() && held_.empty() && leaving_.empty() &&
         !triangles_;
}

std::size_t Edit::memoryBytes() const {
  std::size_t bytes = sizeof(Edit) + removed_->size() * sizeof(Index);
  if (positions_) bytes += bytesOf(*positions_);
  for (const Patch& patch : patches_) {
    bytes += sizeof(Patch) + patch.rows->size() * sizeof(Index) + bytesOf(patch.values) + bytesOf(patch.ends);
  }
  for (const Held& held : held_) bytes += sizeof(Held) + bytesOf(held.attribute.column);
  if (triangles_) bytes += triangles_->size() * sizeof(Triangle);
  return bytes;
}

std::vector<Edit::Touched> Edit::touched() const {
  std::vector<Touched> columns;
  if (positions_) columns.push_back({"", nullptr});
  for (const Patch& patch : patches_) columns.push_back({patch.name, patch.rows});
  std::vector<std::string> whole = leaving_;
  for (const Held& held : held_) {
    if (!contains(whole, held.attribute.name)) whole.push_back(held.attribute.name);
  }
  for (std::string& name : whole) columns.push_back({std::move(name), nullptr});
  return columns;
}

IndexMap Edit::apply(PointSet& points) {
  if (applied_) throw InvalidInput("the edit is already applied");
  throwUnlessFits(points);
  exchange(points);
  return mapOfApplying();
}

IndexMap Edit::revert(PointSet& points) {
  if (!applied_) throw InvalidInput("the edit is not applied");
  throwUnlessFits(points);
  exchange(points);
  return mapOfReverting();
}

void Edit::throwUnlessFits(const PointSet& points) const {
  const Index expected = applied_ ? sizeAfter() : sizeBefore();
  if (points.size() != expected) {
    throw InvalidInput(
        fmt::format("the edit does not fit: the set has {} points, expected {}", points.size(), expected));
  }
  for (const Patch& patch : patches_) {
    if (!patch.name.empty()) throwUnlessHas(points, patch.name, patch.values.type());
  }
  for (const std::string& name : leaving_) {
    if (!points.has(name))
      throw InvalidInput(fmt::format("the edit does not fit: there is no attribute '{}'", name));
  }
  for (const auto& [attribute, position] : held_) {
    if (points.has(attribute.name) && !contains(leaving_, attribute.name)) {
      throw InvalidInput(
          fmt::format("the edit does not fit: there is an attribute '{}' already", attribute.name));
    }
  }
  if (!changesRows()) return;
  for (const Attribute& attribute : points.attributes()) {
    const bool known = contains(leaving_, attribute.name) ||
                       std::ranges::find(patches_, attribute.name, &Patch::name) != patches_.end();
    if (!known) {
      throw InvalidInput(
          fmt::format("the edit does not fit: it does not know attribute '{}'", attribute.name));
    }
  }
}

// Each part swaps what the set has for what the edit holds. Positions come first: they say how long a column
// must be.
void Edit::exchange(PointSet& points) {
  if (positions_) std::swap(*positions_, points.positions_);
  for (Patch& patch : patches_) exchangePatch(points, patch);
  exchangeHeld(points);
  if (triangles_) std::swap(triangles_, points.triangles_);
  if (changesRows()) std::swap(topologyId_, points.topologyId_);
  applied_ = !applied_;
}

void Edit::exchangePatch(PointSet& points, Patch& patch) {
  Column& target = patch.name.empty() ? points.positions_ : points.find(patch.name)->column;
  std::visit(
      [&](auto& column) {
        using Values = std::decay_t<decltype(column)>;
        auto& ends = std::get<Values>(patch.ends.edit());
        auto& values = std::get<Values>(patch.values.edit());
        // Down to the rows that both sides have.
        Values leaving;
        if (applied_) {
          leaving.assign(column.begin() + kept_, column.end());
          column.resize(kept_);
        } else {
          leaving = gather(column, *removed_);
          removeRowsFrom(column, *removed_);
        }
        for (std::size_t r = 0; r < values.size(); ++r) std::swap(column[(*patch.rows)[r]], values[r]);
        // Up to those of the other side.
        if (applied_) {
          insertRowsInto(column, *removed_, ends);
        } else {
          column.insert(column.end(), ends.begin(), ends.end());
        }
        ends = std::move(leaving);
      },
      target.edit());
}

void Edit::exchangeHeld(PointSet& points) {
  std::vector<Held> leaving;
  std::vector<Attribute>& attributes = points.attributes_;
  for (std::size_t position = 0; position < attributes.size(); ++position) {
    if (contains(leaving_, attributes[position].name)) leaving.push_back({attributes[position], position});
  }
  std::erase_if(attributes, [&](const Attribute& attribute) { return contains(leaving_, attribute.name); });
  leaving_.clear();
  for (Held& held : held_) {
    leaving_.push_back(held.attribute.name);
    points.insert(std::move(held.attribute), held.position);
  }
  held_ = std::move(leaving);
}

IndexMap Edit::mapOfApplying() const {
  if (!changesRows()) return IndexMap(sizeAfter());
  std::vector<Index> newRows(sizeBefore());
  Index next = 0;
  for (Index row = 0; row < sizeBefore(); ++row) {
    const bool gone = next < removed_->size() && (*removed_)[next] == row;
    newRows[row] = gone ? IndexMap::kGone : row - next;
    if (gone) ++next;
  }
  return {std::move(newRows), sizeAfter()};
}

IndexMap Edit::mapOfReverting() const {
  if (!changesRows()) return IndexMap(sizeBefore());
  std::vector<Index> newRows(sizeAfter(), IndexMap::kGone);
  Index next = 0;
  for (Index row = 0; row < sizeBefore(); ++row) {
    if (next < removed_->size() && (*removed_)[next] == row) {
      ++next;
    } else {
      newRows[row - next] = row;
    }
  }
  return {std::move(newRows), sizeBefore()};
}

}  // namespace stipple
