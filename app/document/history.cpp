#include "app/document/history.h"

#include <fmt/format.h>

#include <deque>
#include <utility>

#include "app/document/spill_file.h"
#include "core/points/edit_file.h"

namespace stipple {

namespace {

// An entry and where its edit is: in memory or in the spill file.
struct Slot {
  std::string title;
  std::optional<Recipe::Step> recipeStep;
  std::optional<Edit> edit;
  std::size_t memoryBytes = 0;  // of the edit, while it is in memory
  SpillFile::Extent extent = {};
};

}  // namespace

struct History::State {
  explicit State(HistoryOptions given)
      : options(std::move(given)), spillFile(std::make_unique<SpillFile>(options.spillFolder)) {}

  HistoryOptions options;
  std::unique_ptr<SpillFile> spillFile;
  std::deque<Slot> slots;
  std::size_t position = 0;
  std::size_t memoryBytes = 0;
  std::optional<std::size_t> returned;  // the slot whose edit the owner may still be looking at
  std::vector<std::optional<Recipe::Step>> givenUp;
  std::size_t toTell = 0;  // entries given up since the last message
  std::string reason;      // why

  void hold(Slot& slot, Edit edit);
  void release(Slot& slot);
  const Edit& exchange(std::size_t entry, PointSet& points);
  void keepCap();
  std::optional<std::size_t> findFarthest() const;
  bool spill(Slot& slot);
  bool giveUpOldest();
};

void History::State::hold(Slot& slot, Edit edit) {
  slot.memoryBytes = edit.memoryBytes();
  memoryBytes += slot.memoryBytes;
  slot.edit = std::move(edit);
}

// Forgets the edit, wherever it is.
void History::State::release(Slot& slot) {
  if (slot.edit) {
    memoryBytes -= slot.memoryBytes;
  } else {
    spillFile->drop(slot.extent);
  }
  slot.edit.reset();
}

// Applies or reverts the edit of an entry, after reading it back where it was spilled.
const Edit& History::State::exchange(std::size_t entry, PointSet& points) {
  Slot& slot = slots[entry];
  Edit edit =
      slot.edit ? std::move(*slot.edit) : parseEdit(spillFile->read(slot.extent), EditWriter::kThisProgram);
  try {
    edit.isApplied() ? edit.revert(points) : edit.apply(points);
  } catch (...) {
    if (slot.edit) slot.edit = std::move(edit);
    throw;
  }
  release(slot);
  hold(slot, std::move(edit));
  position = slot.edit->isApplied() ? entry + 1 : entry;
  returned = entry;
  keepCap();
  return *slots[*returned].edit;
}

void History::State::keepCap() {
  while (memoryBytes > options.memoryCap) {
    const auto farthest = findFarthest();
    if (!farthest || (!spill(slots[*farthest]) && !giveUpOldest())) return;
  }
}

// The entry in memory that most steps of undo or redo lie before.
std::optional<std::size_t> History::State::findFarthest() const {
  std::optional<std::size_t> farthest;
  std::size_t most = 0;
  for (std::size_t entry = 0; entry < slots.size(); ++entry) {
    const std::size_t steps = entry < position ? position - entry : entry + 1 - position;
    if (!slots[entry].edit || entry == returned || steps < most) continue;
    most = steps;
    farthest = entry;
  }
  return farthest;
}

bool History::State::spill(Slot& slot) {
  if (options.spillFolder.empty()) {
    reason = "the memory set aside for it is full";
    return false;
  }
  try {
    slot.extent = spillFile->write(formatEdit(*slot.edit));
  } catch (const IoError& error) {
    reason = error.what();
    return false;
  }
  memoryBytes -= slot.memoryBytes;
  slot.edit.reset();
  return true;
}

// The oldest that is done, as nothing can be undone beyond it; otherwise the newest that is undone.
bool History::State::giveUpOldest() {
  const bool oldest = position > 0 && returned != 0;
  const std::size_t entry = oldest ? 0 : slots.size() - 1;
  if (slots.size() < 2 || entry == returned) return false;
  release(slots[entry]);
  if (oldest) {
    givenUp.push_back(std::move(slots.front().recipeStep));
    slots.pop_front();
    --position;
    if (returned) --*returned;
  } else {
    slots.pop_back();
  }
  ++toTell;
  return true;
}

History::History(HistoryOptions options) : state_(std::make_unique<State>(std::move(options))) {}
History::~History() = default;
History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

void History::push(HistoryEntry entry) {
  State& state = *state_;
  state.returned.reset();
  while (state.slots.size() > state.position) {
    state.release(state.slots.back());
    state.slots.pop_back();
  }
  state.slots.push_back(
      {.title = std::move(entry.title), .recipeStep = std::move(entry.recipeStep), .edit = {}});
  state.hold(state.slots.back(), std::move(entry.edit));
  ++state.position;
  state.keepCap();
}

std::size_t History::size() const {
  return state_->slots.size();
}

std::size_t History::position() const {
  return state_->position;
}

const std::string& History::title(std::size_t entry) const {
  return state_->slots.at(entry).title;
}

const std::optional<Recipe::Step>& History::recipeStep(std::size_t entry) const {
  return state_->slots.at(entry).recipeStep;
}

Edit History::edit(std::size_t entry) const {
  const Slot& slot = state_->slots.at(entry);
  return slot.edit ? *slot.edit : parseEdit(state_->spillFile->read(slot.extent), EditWriter::kThisProgram);
}

std::size_t History::givenUp() const {
  return state_->givenUp.size();
}

const std::vector<std::optional<Recipe::Step>>& History::givenUpSteps() const {
  return state_->givenUp;
}

const Edit& History::undo(PointSet& points) {
  return state_->exchange(state_->position - 1, points);
}

const Edit& History::redo(PointSet& points) {
  return state_->exchange(state_->position, points);
}

std::size_t History::memoryBytes() const {
  return state_->memoryBytes;
}

std::size_t History::spilledBytes() const {
  return state_->spillFile->bytes();
}

std::optional<std::string> History::takeMessage() {
  const std::size_t count = std::exchange(state_->toTell, 0);
  if (count == 0) return std::nullopt;
  return fmt::format("{} of the history had to be given up: {}.",
                     count == 1 ? "One step" : fmt::format("{} steps", count), state_->reason);
}

}  // namespace stipple
