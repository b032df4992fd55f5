#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/document/history.h"
#include "app/document/journal.h"

namespace stipple {

/// Tells a journal what a document does. States are numbered by the entries that are done, given-up ones too.
/// The journal knows a window of the history; what is undone or done again beyond it goes into the journal as
/// a whole.
class DocumentJournal {
 public:
  void keep(std::unique_ptr<Journal> journal, std::size_t firstState, std::size_t lastState);
  bool isKept() const { return journal_ != nullptr; }

  /// An edit, not yet applied, led on from `state`.
  void did(std::size_t state, const std::string& title, Edit edit,
           const std::optional<Recipe::Step>& recipeStep);
  /// What the journal must be told of the entry that is about to be undone or redone: nothing where it knows
  /// it.
  std::optional<Edit> unknownUndo(const History& history) const;
  std::optional<Edit> unknownRedo(const History& history) const;
  /// It was, and the document stands behind it now.
  void undid(const History& history, std::optional<Edit> unknown);
  void redid(const History& history, std::optional<Edit> unknown);
  /// `file` holds the state `saved`, from which the document has gone on to `points`. None: it cannot be
  /// reached any more.
  void saved(const std::filesystem::path& file, std::optional<std::size_t> saved, const History& history,
             const PointSet& points);

  std::optional<std::string> takeMessage();

 private:
  void restart(const std::filesystem::path& file, std::size_t saved, const History& history, PointSet points);
  void giveUp(const std::string& reason);

  std::unique_ptr<Journal> journal_;
  std::size_t first_ = 0, last_ = 0;  // the states between which the journal knows all edits
  std::optional<std::string> message_;
};

}  // namespace stipple
