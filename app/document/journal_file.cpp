#include "app/document/journal_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <system_error>
#include <utility>

#include "core/points/edit_file.h"

namespace stipple {

namespace {

constexpr std::string_view kSuffix = ".journal";

// Stands before every payload.
struct Frame {
  std::uint64_t bytes = 0;
  std::uint64_t checksum = 0;
};

[[noreturn]] void failAt(const std::filesystem::path& path, int error) {
  throw IoError(fmt::format("{}: {}", path.string(), std::generic_category().message(error)));
}

// Multiplies words of 8 bytes into a sum; every bit of a word reaches the lower half by the shift.
std::uint64_t checksumOf(std::span<const std::byte> bytes, std::uint64_t sum = 0) {
  constexpr std::uint64_t kPrime = 0x9E3779B185EBCA87;  // of XXH64
  sum ^= (bytes.size() + 1) * kPrime;
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t count = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), count);
    sum = (sum ^ word) * kPrime;
    sum ^= sum >> 32;
    bytes = bytes.subspan(count);
  }
  return sum;
}

void putNumber(std::vector<std::byte>& payload, std::uint64_t value) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&value);
  payload.insert(payload.end(), bytes, bytes + sizeof value);
}

void putText(std::vector<std::byte>& payload, const std::string& text) {
  putNumber(payload, text.size());
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  payload.insert(payload.end(), bytes, bytes + text.size());
}

std::span<const std::byte> take(std::span<const std::byte>& payload, std::uint64_t count) {
  if (count > payload.size()) throw InvalidInput("a record of the journal ends too early");
  const auto taken = payload.first(count);
  payload = payload.subspan(count);
  return taken;
}

std::uint64_t takeNumber(std::span<const std::byte>& payload) {
  std::uint64_t value = 0;
  std::memcpy(&value, take(payload, sizeof value).data(), sizeof value);
  return value;
}

std::string takeText(std::span<const std::byte>& payload) {
  const auto bytes = take(payload, takeNumber(payload));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool hasEdit(JournalRecordKind kind) {
  return kind == JournalRecordKind::kEdit || kind == JournalRecordKind::kUndone;
}

std::vector<std::byte> payloadOf(const JournalRecord& record) {
  std::vector<std::byte> payload = {static_cast<std::byte>(record.kind)};
  if (record.kind == JournalRecordKind::kBase) {
    putText(payload, record.base.file.string());
    putNumber(payload, record.base.bytes);
    putNumber(payload, static_cast<std::uint64_t>(record.base.modified));
    putNumber(payload, record.base.fingerprint);
  } else if (hasEdit(record.kind)) {
    putText(payload, record.title);
    putText(payload, record.recipeStep);
    const std::vector<std::byte> edit = formatEdit(record.edit);
    payload.insert(payload.end(), edit.begin(), edit.end());
  }
  return payload;
}

JournalRecordKind kindOf(std::span<const std::byte> payload) {
  const auto kind = static_cast<JournalRecordKind>(payload.front());
  if (kind > JournalRecordKind::kUndone) throw InvalidInput("the journal has a record of an unknown kind");
  return kind;
}

// A new file under a name of its own, and the hold on it.
int createLocked(std::string& name) {
  const std::string form = name;
  while (true) {
    name = form;
    const int descriptor = ::mkostemps(name.data(), static_cast<int>(kSuffix.size()), O_CLOEXEC);
    if (descriptor < 0) failAt(form, errno);
    struct stat status {};
    const bool isHeld = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &status) == 0;
    // Somebody who looks for lost work may have taken it for that in the meantime, and removed it.
    if (isHeld && status.st_nlink > 0) return descriptor;
    ::close(descriptor);
  }
}

}  // namespace

JournalBase describeBase(const std::filesystem::path& file) {
  constexpr std::size_t kSample = 64 << 10;
  JournalBase base{.file = std::filesystem::absolute(file)};
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) failAt(file, errno);
  struct stat status {};
  ::fstat(descriptor, &status);
  base.bytes = static_cast<std::uint64_t>(status.st_size);
  base.modified = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
  std::vector<std::byte> sample(kSample);
  const std::uint64_t last = base.bytes - std::min<std::uint64_t>(base.bytes, kSample);
  for (const std::uint64_t offset : {std::uint64_t{0}, last / 2, last}) {
    const ssize_t count = ::pread(descriptor, sample.data(), kSample, static_cast<off_t>(offset));
    const int error = errno;
    if (count < 0) ::close(descriptor), failAt(file, error);
    base.fingerprint = checksumOf(std::span(sample).first(static_cast<std::size_t>(count)), base.fingerprint);
  }
  ::close(descriptor);
  return base;
}

JournalFile JournalFile::create(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  std::string name = (folder / fmt::format("work-XXXXXX{}", kSuffix)).string();
  const int descriptor = createLocked(name);
  return {name, descriptor};
}

std::optional<JournalFile> JournalFile::open(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    ::close(descriptor);
    return std::nullopt;
  }
  return JournalFile(path, descriptor);
}

JournalFile::~JournalFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

JournalFile::JournalFile(JournalFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      end_(other.end_),
      isTrimmed_(other.isTrimmed_) {}

JournalFile& JournalFile::operator=(JournalFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(end_, other.end_);
  std::swap(isTrimmed_, other.isTrimmed_);
  return *this;
}

void JournalFile::fail(int error) const {
  failAt(path_, error);
}

// False where the file ends before.
bool JournalFile::readAt(std::uint64_t offset, std::byte* bytes, std::size_t count) const {
  for (std::size_t done = 0; done < count;) {
    const ssize_t some = ::pread(descriptor_, bytes + done, count - done, static_cast<off_t>(offset + done));
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) fail(errno);
    if (some == 0) return false;
    done += static_cast<std::size_t>(some);
  }
  return true;
}

std::optional<std::vector<std::byte>> JournalFile::readPayload() {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail(errno);
  const auto size = static_cast<std::uint64_t>(status.st_size);
  Frame frame;
  if (!readAt(end_, reinterpret_cast<std::byte*>(&frame), sizeof frame)) return std::nullopt;
  if (frame.bytes == 0 || frame.bytes > size - end_ - sizeof frame) return std::nullopt;
  std::vector<std::byte> payload(frame.bytes);
  if (!readAt(end_ + sizeof frame, payload.data(), payload.size())) return std::nullopt;
  if (checksumOf(payload) != frame.checksum) return std::nullopt;
  end_ += sizeof frame + payload.size();
  return payload;
}

std::optional<JournalRecordKind> JournalFile::skip() {
  const auto payload = readPayload();
  return payload ? std::optional(kindOf(*payload)) : std::nullopt;
}

std::optional<JournalRecord> JournalFile::read() {
  const auto payload = readPayload();
  if (!payload) return std::nullopt;
  JournalRecord record{.kind = kindOf(*payload)};
  auto left = std::span(*payload).subspan(1);
  if (record.kind == JournalRecordKind::kBase) {
    record.base.file = takeText(left);
    record.base.bytes = takeNumber(left);
    record.base.modified = static_cast<std::int64_t>(takeNumber(left));
    record.base.fingerprint = takeNumber(left);
  } else if (hasEdit(record.kind)) {
    record.title = takeText(left);
    record.recipeStep = takeText(left);
    record.edit = parseEdit(left, EditWriter::kAnotherProgram);
  }
  return record;
}

void JournalFile::append(const JournalRecord& record) {
  if (!isTrimmed_ && ::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) fail(errno);
  isTrimmed_ = true;
  const std::vector<std::byte> payload = payloadOf(record);
  const Frame frame{.bytes = payload.size(), .checksum = checksumOf(payload)};
  std::uint64_t offset = end_;
  for (auto bytes : {std::as_bytes(std::span(&frame, 1)), std::span<const std::byte>(payload)}) {
    while (!bytes.empty()) {
      const ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) fail(count < 0 ? errno : ENOSPC);
      offset += static_cast<std::uint64_t>(count);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }
  end_ = offset;
}

void JournalFile::sync() {
  if (::fdatasync(descriptor_) != 0) fail(errno);
}

void JournalFile::replace(const JournalFile& other) {
  if (::rename(path_.c_str(), other.path_.c_str()) != 0) fail(errno);
  path_ = other.path_;
}

void JournalFile::remove() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace stipple
