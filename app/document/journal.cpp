#include "app/document/journal.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace stipple {

struct Journal::Writer {
  explicit Writer(JournalFile given) : file(std::move(given)), thread([this] { work(); }) {}
  ~Writer() {
    {
      const std::lock_guard lock(mutex);
      isEnding = true;
      changed.notify_all();
    }
    thread.join();
    file.remove();
  }

  void append(JournalRecord record) {
    const std::lock_guard lock(mutex);
    if (hasFailed) return;
    queue.push_back(std::move(record));
    changed.notify_all();
  }

  void work();
  void write(const std::deque<JournalRecord>& records);

  JournalFile file;  // of the thread, until it ends
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<JournalRecord> queue;
  bool isWriting = false, isEnding = false, hasFailed = false;
  std::optional<std::string> message;
  std::thread thread;
};

// Everything that waits is written, then synced once.
void Journal::Writer::work() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [this] { return isEnding || !queue.empty(); });
    if (isEnding) return;
    const std::deque<JournalRecord> records = std::exchange(queue, {});
    isWriting = true;
    lock.unlock();
    std::string failure;
    try {
      write(records);
    } catch (const std::exception& error) {
      failure = error.what();
    }
    lock.lock();
    if (!failure.empty()) {
      hasFailed = true;
      queue.clear();
      message = fmt::format("The work is no longer saved against a crash: {}.", failure);
    }
    isWriting = false;
    changed.notify_all();
  }
}

void Journal::Writer::write(const std::deque<JournalRecord>& records) {
  // A new base makes all before it superfluous. The new file takes the place of the old one when it is
  // complete.
  const auto last =
      std::ranges::find(records.rbegin(), records.rend(), JournalRecordKind::kBase, &JournalRecord::kind);
  if (last == records.rend()) {
    for (const JournalRecord& record : records) file.append(record);
    file.sync();
    return;
  }
  JournalFile anew = JournalFile::create(file.path().parent_path());
  for (auto record = last.base() - 1; record != records.end(); ++record) anew.append(*record);
  anew.sync();
  anew.replace(file);
  file = std::move(anew);
}

namespace {

JournalFile createOn(const std::filesystem::path& folder, const JournalBase& base) {
  JournalFile file = JournalFile::create(folder);
  file.append({.kind = JournalRecordKind::kBase, .base = base});
  return file;
}

}  // namespace

Journal::Journal(const std::filesystem::path& folder, const JournalBase& base)
    : Journal(createOn(folder, base)) {}
Journal::Journal(JournalFile file) : writer_(std::make_unique<Writer>(std::move(file))) {}
Journal::~Journal() = default;

void Journal::appendEdit(std::string title, Edit edit, std::string recipeStep) {
  writer_->append({.kind = JournalRecordKind::kEdit,
                   .title = std::move(title),
                   .recipeStep = std::move(recipeStep),
                   .edit = std::move(edit)});
}

void Journal::appendUndo() {
  writer_->append({.kind = JournalRecordKind::kUndo});
}

void Journal::appendRedo() {
  writer_->append({.kind = JournalRecordKind::kRedo});
}

void Journal::appendUndone(std::string title, Edit edit, std::string recipeStep) {
  writer_->append({.kind = JournalRecordKind::kUndone,
                   .title = std::move(title),
                   .recipeStep = std::move(recipeStep),
                   .edit = std::move(edit)});
}

void Journal::restart(const JournalBase& base) {
  writer_->append({.kind = JournalRecordKind::kBase, .base = base});
}

void Journal::flush() {
  std::unique_lock lock(writer_->mutex);
  writer_->changed.wait(lock, [this] { return writer_->queue.empty() && !writer_->isWriting; });
}

std::optional<std::string> Journal::takeMessage() {
  const std::lock_guard lock(writer_->mutex);
  return std::exchange(writer_->message, std::nullopt);
}

namespace {

// What stands in a journal that nobody holds; nothing where it is no journal or holds no work.
std::optional<LostWork> describe(JournalFile& file) {
  try {
    const auto first = file.read();
    if (!first || first->kind != JournalRecordKind::kBase) return std::nullopt;
    LostWork work{.journal = file.path(), .base = first->base};
    while (const auto kind = file.skip()) {
      if (*kind == JournalRecordKind::kEdit || *kind == JournalRecordKind::kUndone) ++work.entries;
    }
    if (work.entries == 0) return std::nullopt;
    struct stat status {};
    ::stat(file.path().c_str(), &status);
    work.modified = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
    return work;
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<LostWork> findLostWork(const std::filesystem::path& folder) {
  std::vector<LostWork> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".journal") continue;
    auto file = JournalFile::open(entry.path());
    if (!file) continue;
    try {
      if (auto work = describe(*file)) {
        found.push_back(std::move(*work));
      } else {
        file->remove();
      }
    } catch (const IoError&) {
      // What cannot be read now may be readable another time.
    }
  }
  std::ranges::sort(found, std::ranges::greater(), &LostWork::modified);
  return found;
}

}  // namespace stipple
