#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/change_log.h"
#include "app/document/document_journal.h"
#include "app/document/history.h"
#include "app/document/recipe.h"
#include "app/document/saved_state.h"
#include "core/io/point_io.h"
#include "core/points/edit.h"
#include "core/points/point_set.h"

namespace stipple {

/// A point set that the user works on: its file, its history, its journal. Belongs to one thread. Every
/// change passes through here as an Edit, and can be undone bit for bit.
class Document {
 public:
  /// `path` is where the points came from; saving goes there unless told otherwise.
  Document(PointSet points, std::filesystem::path path, HistoryOptions history = {});

  const PointSet& points() const { return points_; }
  const std::filesystem::path& path() const { return path_; }
  const History& history() const { return history_; }
  /// Grows with every change of the points.
  std::uint64_t revision() const { return log_.revision(); }
  DocumentChange changedSince(std::uint64_t revision) const { return log_.since(revision); }

  /// Journal entries follow every change from now on. The points must be those of the journal's base: throws
  /// InvalidInput where they are modified. Null: none. A recovered document keeps its journal already.
  void keepJournal(std::unique_ptr<Journal> journal);
  bool keepsJournal() const { return journal_.isKept(); }

  /// Applies the edit as one entry of the history. An empty edit is no entry. Throws InvalidInput, changing
  /// nothing, where it does not fit, or while a stroke is going on.
  void commit(std::string title, Edit edit, std::optional<Recipe::Step> recipeStep = {});

  /// A stroke is one entry made of many small changes, which are seen at once. `paint` changes values of the
  /// points that it is given (never rows) and returns what it touched.
  void beginStroke(std::string title);
  template <class Paint>
  void paint(Paint&& paint) {
    try {
      record(paint(strokePoints()));
    } catch (...) {
      recordUnknown();
      throw;
    }
  }
  /// A stroke that changed nothing is no entry.
  void endStroke(std::optional<Recipe::Step> recipeStep);
  /// Puts everything back as it was before the stroke.
  void cancelStroke();
  bool isInStroke() const { return beforeStroke_.has_value(); }

  /// False where there is nothing to undo or redo, or a stroke is going on. Throw IoError, changing nothing,
  /// where an edit cannot be read back from the disk; so does goTo, having gone as far as it could.
  bool undo();
  bool redo();
  /// Undoes or redoes until `position` entries are done, or all of them.
  void goTo(std::size_t position);

  /// The points differ from the file (by what was done, not by bits).
  bool isModified() const { return !saved_.is(state()); }
  /// Writes and takes the file as the document's own where it holds all that the points have. Returns a
  /// sentence for each thing that it does not hold. Throws as writePoints does.
  std::vector<std::string> save(const std::filesystem::path& path, const WriteOptions& options,
                                Progress& progress);
  /// After the points of revision `revision` were written by somebody else (a worker).
  void markSaved(const std::filesystem::path& path, std::uint64_t revision);

  /// The steps that are done and can be done again elsewhere; how many cannot.
  struct DoneAsRecipe {
    Recipe recipe;
    std::size_t leftOut = 0;
  };
  DoneAsRecipe recipe() const;

  /// A sentence about what happened meanwhile (undo given up, the journal cannot be written), or nothing.
  std::optional<std::string> takeMessage();

 private:
  friend class Recovery;

  PointSet& strokePoints();
  void record(std::vector<Edit::Touched> touched);
  void recordUnknown();
  void push(std::string title, Edit edit, std::optional<Recipe::Step> recipeStep);
  std::size_t state() const { return history_.givenUp() + history_.position(); }

  PointSet points_;
  std::filesystem::path path_;
  History history_;
  ChangeLog log_;
  SavedState saved_;
  DocumentJournal journal_;
  std::optional<PointSet> beforeStroke_;
  std::string strokeTitle_;
};

}  // namespace stipple
