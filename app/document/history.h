#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/recipe.h"
#include "core/points/edit.h"

namespace stipple {

/// One thing that the user did and can undo.
struct HistoryEntry {
  std::string title;                            ///< as the history list shows it: "Paint seeds"
  Edit edit;                                    ///< applied
  std::optional<Recipe::Step> recipeStep = {};  ///< none: cannot be done again on another scan
};

struct HistoryOptions {
  std::size_t memoryCap = std::size_t{512} << 20;  ///< bytes of edits that stay in memory
  std::filesystem::path spillFolder = {};  ///< where the rest goes; empty: the oldest edits are given up
};

/// What was done to a point set, in order, and where in it the point set stands. Edits beyond the cap go to a
/// file in the spill folder, farthest from the present first, and come back when their turn comes; where the
/// disk is full the oldest are given up. Two edits are in memory whatever they take: the one that undo or
/// redo returned last and, where nothing can be spilled, the newest.
class History {
 public:
  explicit History(HistoryOptions options = {});
  ~History();
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;

  /// Of an edit that has been applied. Drops what was undone.
  void push(HistoryEntry entry);

  /// Entries that can still be undone or done again, oldest first. The first `position()` of them are done.
  std::size_t size() const;
  std::size_t position() const;
  const std::string& title(std::size_t entry) const;
  const std::optional<Recipe::Step>& recipeStep(std::size_t entry) const;
  /// A copy of its edit, on the side where it is. Throws IoError where a spilled edit cannot be read back.
  Edit edit(std::size_t entry) const;
  /// Entries that were given up because nothing could hold them; they are done and stay so.
  std::size_t givenUp() const;
  /// The recipe steps of these, oldest first.
  const std::vector<std::optional<Recipe::Step>>& givenUpSteps() const;

  bool canUndo() const { return position() > 0; }
  bool canRedo() const { return position() < size(); }
  /// The edit that was taken back or done again, in its state after that; valid until the next call. Throws
  /// IoError, changing nothing, where a spilled edit cannot be read back.
  const Edit& undo(PointSet& points);
  const Edit& redo(PointSet& points);

  std::size_t memoryBytes() const;
  std::size_t spilledBytes() const;
  /// A sentence about what happened since the last call (edits given up), or nothing.
  std::optional<std::string> takeMessage();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stipple
