#include "app/document/recovery.h"

#include <fmt/format.h>

#include <utility>

namespace stipple {

namespace {

// What the records of a journal lead to: the edits from the earliest state on, and where in them the work
// stood.
struct Replay {
  PointSet earliest;  // the state before the first edit
  std::vector<JournalRecord> edits = {};
  std::size_t position = 0;
  std::optional<std::size_t> base = 0;  // the state that the file holds, where the edits lead there

  void add(JournalRecord record);

 private:
  void edit(JournalRecord record);
  void takeBack(JournalRecord record);
};

void Replay::add(JournalRecord record) {
  switch (record.kind) {
    case JournalRecordKind::kEdit:
      return edit(std::move(record));
    case JournalRecordKind::kUndone:
      return takeBack(std::move(record));
    case JournalRecordKind::kUndo:
      if (position == 0) throw InvalidInput("there is nothing to undo");
      --position;
      return;
    case JournalRecordKind::kRedo:
      if (position == edits.size()) throw InvalidInput("there is nothing to redo");
      ++position;
      return;
    case JournalRecordKind::kBase:
      throw InvalidInput("it begins twice");
  }
}

void Replay::edit(JournalRecord record) {
  if (base > position) base.reset();
  edits.resize(position);
  edits.push_back(std::move(record));
  ++position;
}

void Replay::takeBack(JournalRecord record) {
  if (position != 0) throw InvalidInput("an edit of the file is taken back out of turn");
  record.edit.revert(earliest);
  edits.insert(edits.begin(), std::move(record));
  if (base) ++*base;
}

std::optional<Recipe::Step> parseStep(const std::string& text, const Registry& registry) {
  if (text.empty()) return std::nullopt;
  try {
    const Recipe recipe = parseRecipe(text, registry);
    if (!recipe.steps.empty()) return recipe.steps.front();
  } catch (const InvalidInput&) {
    // A plugin that is not there any more, or another version of it.
  }
  return std::nullopt;
}

void requireSameBase(const JournalBase& base) {
  std::optional<JournalBase> now;
  try {
    now = describeBase(base.file);
  } catch (const IoError&) {
    throw InvalidInput("the file is missing");
  }
  if (*now != base) throw InvalidInput("the file has changed since");
}

}  // namespace

/// Builds the document of a replay.
class Recovery {
 public:
  static Document build(Replay replay, const std::filesystem::path& path, const Registry& registry,
                        HistoryOptions history, JournalFile file) {
    const std::size_t count = replay.edits.size();
    Document document(std::move(replay.earliest), path, std::move(history));
    for (JournalRecord& record : replay.edits) {
      document.commit(std::move(record.title), std::move(record.edit),
                      parseStep(record.recipeStep, registry));
    }
    while (document.state() > replay.position && document.undo()) {
    }
    document.saved_.save(replay.base);
    document.journal_.keep(std::make_unique<Journal>(std::move(file)), 0, count);
    return document;
  }
};

Document recoverDocument(const LostWork& work, const Registry& registry, Progress& progress,
                         HistoryOptions history) {
  std::size_t number = 0;
  try {
    std::optional<JournalFile> file = JournalFile::open(work.journal);
    if (!file) throw InvalidInput("another program has it, or it is gone");
    const auto first = file->read();
    if (!first || first->kind != JournalRecordKind::kBase) throw InvalidInput("the journal has no beginning");
    requireSameBase(first->base);
    PartialProgress reading(progress, 0, 0.8);
    Replay replay{.earliest = readPoints(first->base.file, reading).points};
    for (auto record = file->read(); record; record = file->read()) {
      progress.throwIfCancelled();
      ++number;
      replay.add(std::move(*record));
    }
    progress.report(0.9, "restoring");
    return Recovery::build(std::move(replay), first->base.file, registry, std::move(history),
                           std::move(*file));
  } catch (const InvalidInput& error) {
    const std::string where = number == 0 ? "" : fmt::format(" (step {} of its journal)", number);
    throw InvalidInput(
        fmt::format("the work on {} cannot be restored{}: {}", work.base.file.string(), where, error.what()));
  }
}

}  // namespace stipple
