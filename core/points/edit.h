#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// Where the rows of a point set went when an edit was applied or reverted.
class IndexMap {
 public:
  static constexpr Index kGone = static_cast<Index>(-1);

  /// Every row stays where it was.
  explicit IndexMap(Index size) : newSize_(size) {}
  IndexMap(std::vector<Index> newRows, Index newSize) : newRows_(std::move(newRows)), newSize_(newSize) {}

  bool isIdentity() const { return newRows_.empty(); }
  Index newSize() const { return newSize_; }
  /// The new row of an old one, or kGone.
  Index operator[](Index oldRow) const { return newRows_.empty() ? oldRow : newRows_[oldRow]; }

 private:
  std::vector<Index> newRows_;  // empty: identity
  Index newSize_;
};

/// The difference of two states of a point set. It holds only what the set lacks: before it is applied the
/// new values, afterwards the old ones; applying and reverting exchange the two, so that undo and redo are
/// identity bit for bit. A value: copies share what they hold. Columns that changed in few rows are held as
/// rows and values, others whole.
class Edit {
 public:
  Edit() = default;

  bool empty() const;
  bool isApplied() const { return applied_; }
  bool changesRows() const { return !removed_->empty() || appended_ > 0; }
  /// Bytes of rows, values and triangles that the edit keeps alive.
  std::size_t memoryBytes() const;

  /// A column in which the two states differ.
  struct Touched {
    std::string name;  ///< empty: the positions
    /// Ascending rows of the state after, below its appended ones. Null: all rows, or the attribute comes,
    /// goes or has another type or place on the other side.
    std::shared_ptr<const std::vector<Index>> rows;
  };
  /// What applying and reverting change, in no order. Where changesRows(), all columns change beyond these
  /// rows.
  std::vector<Touched> touched() const;
  bool changesTriangles() const { return triangles_ != nullptr; }

  /// Both leave the set as it was and throw InvalidInput where it does not fit: another number of points, an
  /// attribute missing or of another type, or the edit already being on that side.
  IndexMap apply(PointSet& points);
  IndexMap revert(PointSet& points);

  friend Edit difference(const PointSet& before, const PointSet& after, std::span<const Index> removedRows);

 private:
  friend class EditBytes;  // edit_file.cpp

  using Rows = std::shared_ptr<const std::vector<Index>>;
  /// A column that both sides have and that differs in few rows.
  struct Patch {
    std::string name;  // empty: the positions
    Rows rows;         // ascending, after removal
    Column values;     // of the other side at `rows`
    Column ends;       // of the rows that only the other side has
  };
  /// An attribute that this side lacks, or has otherwise, and its place in the list of the other side.
  struct Held {
    Attribute attribute;
    std::size_t position;
  };

  static std::optional<Patch> makePatch(const std::string& name, const Column& before, const Column& after,
                                        std::span<const Index> removed);
  void addPositions(const PointSet& before, const PointSet& after);
  void addAttributes(const PointSet& before, const PointSet& after);
  void throwUnlessFits(const PointSet& points) const;
  void exchange(PointSet& points);
  void exchangePatch(PointSet& points, Patch& patch);
  void exchangeHeld(PointSet& points);
  IndexMap mapOfApplying() const;
  IndexMap mapOfReverting() const;

  Index sizeBefore() const { return kept_ + static_cast<Index>(removed_->size()); }
  Index sizeAfter() const { return kept_ + appended_; }

  bool applied_ = false;
  Index kept_ = 0;                                         // rows that both sides have
  Index appended_ = 0;                                     // rows that only the state after has
  Rows removed_ = std::make_shared<std::vector<Index>>();  // rows that only the state before has
  std::optional<Column> positions_;                        // where most positions differ
  std::vector<Patch> patches_;
  std::vector<Held> held_;            // ascending in position
  std::vector<std::string> leaving_;  // names that this side has and the other lacks or has otherwise
  std::shared_ptr<const std::vector<Triangle>> triangles_;  // null: the same on both sides
  ColumnId topologyId_ = 0;                                 // of the other side, where the rows differ
};

/// What leads from `before` to `after`, whose rows are those of `before` without `removedRows` (ascending,
/// unique), in their order, then appended ones. Compares bits, O(rows) for each column that is not shared.
/// The origins must be the same; the number type that positions have in a file is not part of an edit. Throws
/// InvalidInput where the numbers of rows or the origins do not fit.
Edit difference(const PointSet& before, const PointSet& after, std::span<const Index> removedRows = {});

}  // namespace stipple
