#include "app/document/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <future>
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
  std::uint64_t edition = 0;    // of the edit: another one whenever it changes
  std::size_t memoryBytes = 0;  // of the edit, while it is in memory
  SpillFile::Extent extent = {};
};

// Edits on their way to the disk; they stay in memory until they are there.
struct Batch {
  std::vector<std::uint64_t> editions;
  std::vector<Edit> edits;
};

struct WrittenBatch {
  std::vector<std::uint64_t> editions;
  std::vector<SpillFile::Extent> extents;  // of the first of these
  std::string failure;                     // why of the others not
};

WrittenBatch writeBatch(SpillFile& file, Batch batch) {
  WrittenBatch written{.editions = std::move(batch.editions), .extents = {}, .failure = {}};
  try {
    for (const Edit& edit : batch.edits) written.extents.push_back(file.write(formatEdit(edit)));
  } catch (const std::exception& error) {
    written.failure = error.what();
  }
  return written;
}

}  // namespace

struct History::State {
  explicit State(HistoryOptions given) : options(std::move(given)), spillFile(options.spillFolder) {}

  HistoryOptions options;
  SpillFile spillFile;
  std::deque<Slot> slots;
  std::size_t position = 0;
  std::size_t memoryBytes = 0;
  std::uint64_t editions = 0;
  std::optional<std::size_t> returned;  // the slot whose edit the owner may still be looking at
  std::vector<std::optional<Recipe::Step>> givenUp;
  std::size_t toTell = 0;              // entries given up since the last message
  std::string reason;                  // why
  std::future<WrittenBatch> spilling;  // valid while a batch is written

  void hold(Slot& slot, Edit edit);
  void release(Slot& slot);
  const Edit& exchange(std::size_t entry, PointSet& points);
  void keepCap();
  std::vector<std::size_t> findFarthest(std::size_t target) const;
  bool startSpilling(const std::vector<std::size_t>& entries);
  bool finishSpilling();
  bool giveUpOldest();
};

void History::State::hold(Slot& slot, Edit edit) {
  slot.memoryBytes = edit.memoryBytes();
  memoryBytes += slot.memoryBytes;
  slot.edit = std::move(edit);
  slot.edition = ++editions;
}

// Forgets the edit, wherever it is.
void History::State::release(Slot& slot) {
  if (slot.edit) {
    memoryBytes -= slot.memoryBytes;
  } else {
    spillFile.drop(slot.extent);
  }
  slot.edit.reset();
}

// Applies or reverts the edit of an entry, after reading it back where it was spilled.
const Edit& History::State::exchange(std::size_t entry, PointSet& points) {
  Slot& slot = slots[entry];
  Edit edit =
      slot.edit ? std::move(*slot.edit) : parseEdit(spillFile.read(slot.extent), EditWriter::kThisProgram);
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

// Spilling begins before the cap is reached, so that the owner need not wait for the disk; at the cap it
// must.
void History::State::keepCap() {
  using namespace std::chrono_literals;
  if (spilling.valid() && spilling.wait_for(0s) == std::future_status::ready) finishSpilling();
  while (memoryBytes > options.memoryCap) {
    if (!spilling.valid()) {
      const std::vector<std::size_t> farthest = findFarthest(options.memoryCap);
      if (farthest.empty()) return;
      startSpilling(farthest);
    }
    const bool isSpilled = spilling.valid() && finishSpilling();
    if (!isSpilled && !giveUpOldest()) return;
  }
  const std::size_t early = options.memoryCap - options.memoryCap / 4;
  if (memoryBytes > early && !spilling.valid()) startSpilling(findFarthest(early));
}

// The entries in memory that most steps of undo or redo lie before, as many as bring the memory down to
// `target`.
std::vector<std::size_t> History::State::findFarthest(std::size_t target) const {
  std::vector<std::size_t> farthest;
  for (std::size_t entry = 0; entry < slots.size(); ++entry) {
    if (slots[entry].edit && entry != returned) farthest.push_back(entry);
  }
  std::ranges::stable_sort(farthest, std::ranges::greater(), [this](std::size_t entry) {
    return entry < position ? position - entry : entry + 1 - position;
  });
  std::size_t left = memoryBytes, count = 0;
  for (; count < farthest.size() && left > target; ++count) left -= slots[farthest[count]].memoryBytes;
  farthest.resize(count);
  return farthest;
}

// False where there is nowhere to spill to.
bool History::State::startSpilling(const std::vector<std::size_t>& entries) {
  if (options.spillFolder.empty()) {
    reason = "the memory set aside for it is full";
    return false;
  }
  Batch batch;
  for (const std::size_t entry : entries) {
    batch.editions.push_back(slots[entry].edition);
    batch.edits.push_back(*slots[entry].edit);
  }
  spilling = std::async(std::launch::async, [this, batch = std::move(batch)]() mutable {
    return writeBatch(spillFile, std::move(batch));
  });
  return true;
}

// Waits for the batch and lets go of the edits that have not changed since. False where the disk took less.
bool History::State::finishSpilling() {
  const WrittenBatch written = spilling.get();
  for (std::size_t i = 0; i < written.extents.size(); ++i) {
    const auto slot = std::ranges::find(slots, written.editions[i], &Slot::edition);
    if (slot == slots.end() || !slot->edit) {
      spillFile.drop(written.extents[i]);
      continue;
    }
    memoryBytes -= slot->memoryBytes;
    slot->edit.reset();
    slot->extent = written.extents[i];
  }
  if (!written.failure.empty()) reason = written.failure;
  return written.failure.empty();
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
  return slot.edit ? *slot.edit : parseEdit(state_->spillFile.read(slot.extent), EditWriter::kThisProgram);
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
  return state_->spillFile.bytes();
}

std::optional<std::string> History::takeMessage() {
  const std::size_t count = std::exchange(state_->toTell, 0);
  if (count == 0) return std::nullopt;
  return fmt::format("{} of the history had to be given up: {}.",
                     count == 1 ? "One step" : fmt::format("{} steps", count), state_->reason);
}

}  // namespace stipple
