#include "app/document/document.h"

#include <cassert>
#include <utility>

namespace stipple {

Document::Document(PointSet points, std::filesystem::path path, HistoryOptions history)
    : points_(std::move(points)), path_(std::move(path)), history_(std::move(history)) {}

void Document::keepJournal(std::unique_ptr<Journal> journal) {
  if (journal && isModified()) throw InvalidInput("a journal begins with the points of a file");
  journal_.keep(std::move(journal), state(), state());
}

void Document::commit(std::string title, Edit edit, std::optional<Recipe::Step> recipeStep) {
  if (isInStroke()) throw InvalidInput("the points cannot be changed otherwise while a stroke is painted");
  if (edit.empty()) return;
  // A copy that nobody needs would make applying copy the values.
  Edit told = keepsJournal() ? edit : Edit();
  edit.apply(points_);
  journal_.did(state(), title, std::move(told), recipeStep);
  log_.add(changeOf(edit));
  push(std::move(title), std::move(edit), std::move(recipeStep));
}

// Of an edit that is applied and logged.
void Document::push(std::string title, Edit edit, std::optional<Recipe::Step> recipeStep) {
  saved_.branch(state());
  history_.push({.title = std::move(title), .edit = std::move(edit), .recipeStep = std::move(recipeStep)});
  saved_.note(revision(), state());
}

void Document::beginStroke(std::string title) {
  if (isInStroke()) throw InvalidInput("a stroke is painted already");
  beforeStroke_ = points_;
  strokeTitle_ = std::move(title);
}

PointSet& Document::strokePoints() {
  if (!isInStroke()) throw InvalidInput("no stroke has begun");
  return points_;
}

void Document::record(std::vector<Edit::Touched> touched) {
  assert(points_.topologyId() == beforeStroke_->topologyId());
  if (touched.empty()) return;
  log_.add({.everything = false, .triangles = false, .columns = std::move(touched)});
  saved_.note(revision(), std::nullopt);
}

// Painting failed on the way; nobody knows how far it came.
void Document::recordUnknown() {
  if (!isInStroke()) return;
  log_.add({.everything = true});
  saved_.note(revision(), std::nullopt);
}

void Document::endStroke(std::optional<Recipe::Step> recipeStep) {
  if (!isInStroke()) throw InvalidInput("no stroke has begun");
  Edit edit = difference(*beforeStroke_, points_);
  points_ = *std::exchange(beforeStroke_, std::nullopt);
  if (edit.empty()) return saved_.note(revision(), state());
  journal_.did(state(), strokeTitle_, edit, recipeStep);
  // The same bits as were painted, from an edit that knows the old ones now.
  edit.apply(points_);
  push(std::move(strokeTitle_), std::move(edit), std::move(recipeStep));
}

void Document::cancelStroke() {
  if (!isInStroke()) return;
  const Edit back = difference(points_, *beforeStroke_);
  points_ = *std::exchange(beforeStroke_, std::nullopt);
  if (!back.empty()) log_.add(changeOf(back));
  saved_.note(revision(), state());
}

bool Document::undo() {
  if (isInStroke() || !history_.canUndo()) return false;
  std::optional<Edit> unknown = journal_.unknownUndo(history_);
  log_.add(changeOf(history_.undo(points_)));
  journal_.undid(history_, std::move(unknown));
  saved_.note(revision(), state());
  return true;
}

bool Document::redo() {
  if (isInStroke() || !history_.canRedo()) return false;
  std::optional<Edit> unknown = journal_.unknownRedo(history_);
  log_.add(changeOf(history_.redo(points_)));
  journal_.redid(history_, std::move(unknown));
  saved_.note(revision(), state());
  return true;
}

void Document::goTo(std::size_t position) {
  // Entries may be given up on the way.
  const std::size_t target = history_.givenUp() + position;
  while (state() > target && undo()) {
  }
  while (state() < target && redo()) {
  }
}

std::vector<std::string> Document::save(const std::filesystem::path& path, const WriteOptions& options,
                                        Progress& progress) {
  std::vector<std::string> losses = writePoints(path, points_, options, progress);
  if (losses.empty()) markSaved(path, revision());
  return losses;
}

void Document::markSaved(const std::filesystem::path& path, std::uint64_t revision) {
  path_ = path;
  saved_.save(saved_.stateAt(revision));
  journal_.saved(path, saved_.state(), history_, isInStroke() ? *beforeStroke_ : points_);
}

Document::DoneAsRecipe Document::recipe() const {
  DoneAsRecipe done;
  const auto add = [&](const std::optional<Recipe::Step>& step) {
    if (step) {
      done.recipe.steps.push_back(*step);
    } else {
      ++done.leftOut;
    }
  };
  for (const auto& step : history_.givenUpSteps()) add(step);
  for (std::size_t entry = 0; entry < history_.position(); ++entry) add(history_.recipeStep(entry));
  return done;
}

std::optional<std::string> Document::takeMessage() {
  if (auto message = history_.takeMessage()) return message;
  return journal_.takeMessage();
}

}  // namespace stipple
