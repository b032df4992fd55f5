#include "app/document/document_journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace stipple {

namespace {

std::string textOf(const std::optional<Recipe::Step>& step) {
  return step ? formatRecipe({.steps = {*step}}) : std::string();
}

std::size_t stateOf(const History& history) {
  return history.givenUp() + history.position();
}

}  // namespace

void DocumentJournal::keep(std::unique_ptr<Journal> journal, std::size_t firstState, std::size_t lastState) {
  journal_ = std::move(journal);
  first_ = firstState;
  last_ = lastState;
}

void DocumentJournal::did(std::size_t state, const std::string& title, Edit edit,
                          const std::optional<Recipe::Step>& recipeStep) {
  if (!journal_) return;
  journal_->appendEdit(title, std::move(edit), textOf(recipeStep));
  last_ = state + 1;
}

std::optional<Edit> DocumentJournal::unknownUndo(const History& history) const {
  if (!journal_ || stateOf(history) > first_) return std::nullopt;
  return history.edit(history.position() - 1);
}

std::optional<Edit> DocumentJournal::unknownRedo(const History& history) const {
  if (!journal_ || stateOf(history) < last_) return std::nullopt;
  return history.edit(history.position());
}

void DocumentJournal::undid(const History& history, std::optional<Edit> unknown) {
  if (!journal_) return;
  if (!unknown) return journal_->appendUndo();
  const std::size_t entry = history.position();
  journal_->appendUndone(history.title(entry), std::move(*unknown), textOf(history.recipeStep(entry)));
  first_ = stateOf(history);
}

void DocumentJournal::redid(const History& history, std::optional<Edit> unknown) {
  if (!journal_) return;
  if (!unknown) return journal_->appendRedo();
  const std::size_t entry = history.position() - 1;
  journal_->appendEdit(history.title(entry), std::move(*unknown), textOf(history.recipeStep(entry)));
  last_ = stateOf(history);
}

void DocumentJournal::saved(const std::filesystem::path& file, std::optional<std::size_t> saved,
                            const History& history, const PointSet& points) {
  if (!journal_) return;
  if (!saved || *saved < history.givenUp()) return giveUp("what the file holds can no longer be reached");
  try {
    restart(file, *saved, history, points);
  } catch (const IoError& error) {
    giveUp(error.what());
  }
}

void DocumentJournal::restart(const std::filesystem::path& file, std::size_t saved, const History& history,
                              PointSet points) {
  const std::size_t now = stateOf(history);
  const auto entryOf = [&](std::size_t state) { return state - history.givenUp(); };
  // Copies of the edits between the two states, exchanged with a copy of the points, know the other side.
  std::vector<Edit> edits;
  for (std::size_t state = now; state > saved; --state) {
    edits.push_back(history.edit(entryOf(state - 1)));
    edits.back().revert(points);
  }
  for (std::size_t state = now; state < saved; ++state) {
    edits.push_back(history.edit(entryOf(state)));
    edits.back().apply(points);
  }
  journal_->restart(describeBase(file));
  // They were collected from now to saved and are told from saved to now.
  for (std::size_t state = saved; state < now; ++state) {
    const std::size_t entry = entryOf(state);
    journal_->appendEdit(history.title(entry), edits[now - 1 - state], textOf(history.recipeStep(entry)));
  }
  for (std::size_t state = saved; state > now; --state) {
    const std::size_t entry = entryOf(state - 1);
    journal_->appendUndone(history.title(entry), edits[state - 1 - now], textOf(history.recipeStep(entry)));
  }
  first_ = std::min(saved, now);
  last_ = std::max(saved, now);
}

void DocumentJournal::giveUp(const std::string& reason) {
  journal_.reset();
  message_ = fmt::format("The work is no longer saved against a crash: {}.", reason);
}

std::optional<std::string> DocumentJournal::takeMessage() {
  if (message_) return std::exchange(message_, std::nullopt);
  return journal_ ? journal_->takeMessage() : std::nullopt;
}

}  // namespace stipple
