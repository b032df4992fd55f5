#include "app/document/merge.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace stipple {

namespace {

bool areTheSame(const PointSet& a, const PointSet& b) {
  const auto sameAttribute = [](const Attribute& left, const Attribute& right) {
    return left.name == right.name && left.file == right.file && left.column.id() == right.column.id();
  };
  return a.positionColumn().id() == b.positionColumn().id() && a.sharedTriangles() == b.sharedTriangles() &&
         std::ranges::equal(a.attributes(), b.attributes(), sameAttribute);
}

bool sameColumn(const Column& a, const Column& b) {
  return a.id() == b.id() || sameBits(a.values(), b.values());
}

// Three states of the rows that all have: as the run found them, as it left them, as they are now.
class Merger {
 public:
  Merger(const FinishedRun& run, const PointSet& now)
      : then_(run.snapshot), made_(run.result.points), merged_(now) {
    then_.removeRows(run.result.removedRows);
    merged_.removeRows(run.result.removedRows);
    isKept_.resize(then_.size());
  }

  PointSet merge() {
    mergeValues(then_.positionColumn(), made_.positionColumn(), merged_.positionColumn());
    for (const Attribute& attribute : made_.attributes()) mergeAttribute(attribute);
    for (const Attribute& attribute : then_.attributes()) {
      if (!made_.has(attribute.name)) mergeErased(attribute);
    }
    const bool trianglesChanged = made_.triangles() != then_.triangles();
    const bool takesTriangles = trianglesChanged && merged_.triangles() == then_.triangles();
    append();
    if (takesTriangles) merged_.setTriangles(made_.triangles());
    return std::move(merged_);
  }

  Index keptByUser() const { return static_cast<Index>(std::ranges::count(isKept_, 1)); }

 private:
  void mergeAttribute(const Attribute& made) {
    const Attribute* then = then_.find(made.name);
    Attribute* now = merged_.find(made.name);
    if (!then && !now) return;  // comes with append()
    if (!then) return mergeBothNew(made, *now);
    if (sameAttribute(made, *then)) return;
    if (!now || now->type() != then->type()) return keepWhereDifferent(made.column, then->column);
    if (made.type() == then->type()) {
      if (made.file != then->file && now->file == then->file) now->file = made.file;
      return mergeValues(then->column, made.column, now->column);
    }
    // The run made another type of it.
    if (sameColumn(now->column, then->column)) {
      merged_.erase(made.name);
    } else {
      keepWhereDifferent(now->column, then->column);
    }
  }

  bool sameAttribute(const Attribute& made, const Attribute& then) const {
    return made.file == then.file && made.type() == then.type() && !differsInRows(made.column, then.column);
  }

  // Whoever paints on an attribute that was not there began with zeros, or white.
  void mergeBothNew(const Attribute& made, Attribute& now) {
    if (made.type() != now.type()) return keepAll();
    PointSet blank({}, then_.origin());
    std::visit([&](auto values) { values.clear(), blank.set(now.name, std::move(values)); },
               now.column.values());
    blank.appendRows(PointSet(std::vector<Eigen::Vector3f>(then_.size()), then_.origin()));
    mergeValues(blank.find(now.name)->column, made.column, now.column);
  }

  void mergeErased(const Attribute& then) {
    const Attribute* now = merged_.find(then.name);
    if (!now) return;
    if (sameColumn(now->column, then.column)) {
      merged_.erase(then.name);
    } else {
      keepWhereDifferent(now->column, then.column);
    }
  }

  // All of one type. `made` may have appended rows.
  void mergeValues(const Column& then, const Column& made, Column& now) {
    if (made.id() == then.id()) return;
    if (now.id() == then.id() && made.size() == now.size()) {
      now = made;
      return;
    }
    std::visit(
        [&](const auto& before) {
          using Values = std::decay_t<decltype(before)>;
          const auto& results = std::get<Values>(made.values());
          auto& values = std::get<Values>(now.edit());
          for (std::size_t row = 0; row < before.size(); ++row) {
            if (same(results[row], before[row]) || same(values[row], results[row])) continue;
            if (same(values[row], before[row])) {
              values[row] = results[row];
            } else {
              isKept_[row] = 1;
            }
          }
        },
        then.values());
  }

  // The user's attribute stays whole: every point counts that the run would have changed.
  void keepWhereDifferent(const Column& a, const Column& b) {
    if (a.type() != b.type()) return keepAll();
    forEachDifferentRow(a, b, [&](std::size_t row) { isKept_[row] = 1; });
  }

  void keepAll() { std::ranges::fill(isKept_, std::uint8_t{1}); }

  bool differsInRows(const Column& a, const Column& b) const {
    bool differs = false;
    if (a.id() != b.id()) forEachDifferentRow(a, b, [&](std::size_t) { differs = true; });
    return differs;
  }

  template <class Visit>
  void forEachDifferentRow(const Column& a, const Column& b, Visit visit) const {
    std::visit(
        [&](const auto& left) {
          const auto& right = std::get<std::decay_t<decltype(left)>>(b.values());
          for (std::size_t row = 0; row < isKept_.size(); ++row) {
            if (!same(left[row], right[row])) visit(row);
          }
        },
        a.values());
  }

  // The rows and the attributes that the run added.
  void append() {
    if (made_.size() > then_.size()) {
      PointSet more = made_;
      more.removeRows(allRows(then_.size()));
      merged_.appendRows(more);
    }
    const auto attributes = made_.attributes();
    for (std::size_t position = 0; position < attributes.size(); ++position) {
      const Attribute& attribute = attributes[position];
      const Attribute* then = then_.find(attribute.name);
      const bool erasedByUser = then && then->type() == attribute.type();
      if (!merged_.has(attribute.name) && !erasedByUser) merged_.insert(attribute, position);
    }
  }

  static std::vector<Index> allRows(Index size) {
    std::vector<Index> rows(size);
    std::iota(rows.begin(), rows.end(), Index{0});
    return rows;
  }

  template <class T>
  static bool same(const T& a, const T& b) {
    return std::memcmp(static_cast<const void*>(&a), static_cast<const void*>(&b), sizeof(T)) == 0;
  }

  PointSet then_;
  const PointSet& made_;
  PointSet merged_;
  std::vector<std::uint8_t> isKept_;  // by row of then_
};

}  // namespace

MergedRun mergeRun(const FinishedRun& run, const PointSet& now) {
  if (run.snapshot.topologyId() != now.topologyId()) {
    throw InvalidInput("points were added or removed while the process ran, so that its result does not fit");
  }
  if (areTheSame(run.snapshot, now)) return {.edit = run.edit};
  Merger merger(run, now);
  const PointSet merged = merger.merge();
  return {.edit = difference(now, merged, run.result.removedRows), .keptByUser = merger.keptByUser()};
}

}  // namespace stipple
