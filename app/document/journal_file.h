#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/points/edit.h"

namespace stipple {

/// What a journal is about: the file that its first edit applies to, as it was.
struct JournalBase {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
  std::int64_t modified = 0;      ///< nanoseconds since 1970
  std::uint64_t fingerprint = 0;  ///< of the beginning, the middle and the end of its content
  friend bool operator==(const JournalBase&, const JournalBase&) = default;
};

/// Throws IoError where the file cannot be read.
JournalBase describeBase(const std::filesystem::path& file);

/// kUndone: an edit that the base holds and that was taken back, as it was before that.
enum class JournalRecordKind : std::uint8_t { kBase, kEdit, kUndo, kRedo, kUndone };

struct JournalRecord {
  JournalRecordKind kind = JournalRecordKind::kBase;
  JournalBase base = {};        // kBase
  std::string title = {};       // kEdit and kUndone, as the others below
  std::string recipeStep = {};  // a recipe of one step, or nothing
  Edit edit = {};
};

/// A file that nobody else may have open as such. Every record stands behind its length and checksum, so that
/// whatever ends the program leaves complete records and at most one that is not.
class JournalFile {
 public:
  /// A new one in `folder`, which is made where missing. Throws IoError.
  static JournalFile create(const std::filesystem::path& folder);
  /// Nothing where the file is missing or a living program has it.
  static std::optional<JournalFile> open(const std::filesystem::path& path);
  ~JournalFile();
  JournalFile(JournalFile&& other) noexcept;
  JournalFile& operator=(JournalFile&& other) noexcept;

  const std::filesystem::path& path() const { return path_; }
  /// The next record, or nothing behind the last complete one. Throws IoError, and InvalidInput where a
  /// record holds something else than it should.
  std::optional<JournalRecord> read();
  /// The same, without its contents.
  std::optional<JournalRecordKind> skip();
  /// Behind the records that were read; what else there may be goes. Throws IoError.
  void append(const JournalRecord& record);
  /// Waits until everything is on the disk. Throws IoError.
  void sync();
  /// Takes the name and the place of another.
  void replace(const JournalFile& other);
  void remove();

 private:
  JournalFile(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  [[noreturn]] void fail(int error) const;
  bool readAt(std::uint64_t offset, std::byte* bytes, std::size_t count) const;
  std::optional<std::vector<std::byte>> readPayload();

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;  // of the records that were read or written
  bool isTrimmed_ = false;
};

}  // namespace stipple
