#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/journal_file.h"
#include "core/points/edit.h"

namespace stipple {

/// The autosave: every edit, undo and redo is appended to a file by a thread of its own, so that work
/// outlives a crash. The file is locked while its program lives and removed when the journal ends in order. A
/// document drives it.
class Journal {
 public:
  /// A new file in `folder`, which is made where missing. Throws IoError.
  Journal(const std::filesystem::path& folder, const JournalBase& base);
  /// Goes on behind the records of `file` that were read.
  explicit Journal(JournalFile file);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Of an edit as it is before it is applied; `recipeStep` is a recipe of one step or empty. None of these
  /// waits for the disk.
  void appendEdit(std::string title, Edit edit, std::string recipeStep);
  void appendUndo();
  void appendRedo();
  /// Undo of an edit that came before the first of the journal, as it is before it is reverted.
  void appendUndone(std::string title, Edit edit, std::string recipeStep);
  /// The points were saved: what was done is in `base` now. Starts the file anew.
  void restart(const JournalBase& base);
  /// Waits until everything is on the disk.
  void flush();
  /// A sentence, once, when the journal could not be written and is given up.
  std::optional<std::string> takeMessage();

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

/// Work that a program left behind.
struct LostWork {
  std::filesystem::path journal;
  JournalBase base;
  std::size_t entries = 0;    ///< edits, undone ones too
  std::int64_t modified = 0;  ///< of the journal, nanoseconds since 1970
};

/// Journals in `folder` that no living program holds and that have entries, latest first. Others that nobody
/// holds are removed.
std::vector<LostWork> findLostWork(const std::filesystem::path& folder);

}  // namespace stipple
